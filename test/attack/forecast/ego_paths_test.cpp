#include "collision_forge/attack/forecast/ego_paths.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "attack/search/test_scenes.h"

namespace forge {
namespace {

constexpr double kHorizon = 8.0;  // s

/// Eastbound to x = 0, then straight on or left along a quarter circle of 12 m radius.
std::shared_ptr<LaneMap> junction() {
  auto map = emptyMap();
  Lane left;
  left.id = "left";
  for (int i = 0; i <= 12; ++i) {
    const double angle = i * M_PI_2 / 12;
    left.centerline.push_back({12.0 * std::sin(angle), 12.0 - 12.0 * std::cos(angle), angle});
  }
  left.outgoing = {"north"};
  map->lanes = {straightLane("in", {-200.0, 0.0}, {0.0, 0.0}, {"on", "left"}),
                straightLane("on", {0.0, 0.0}, {200.0, 0.0}), left,
                straightLane("north", {12.0, 12.0}, {12.0, 200.0})};
  return map;
}

EgoNow egoAt(const Pose2& pose, double speed) {
  return egoNow(pastTrack(kEgoId, kEgoSize, pose, speed));
}

double sumOf(const std::vector<EgoPath>& paths) {
  return std::accumulate(paths.begin(), paths.end(), 0.0,
                         [](double sum, const EgoPath& path) { return sum + path.weight; });
}

TEST(SampledPath, FollowsALineAndGoesStraightOnBeyondBothEnds) {
  const SampledPath path({{0, 0}, {30, 0}}, 50.0);
  const Pose2 beside = path.poseAt(12.3, 2.0);
  EXPECT_NEAR(beside.x, 12.3, 1e-9);
  EXPECT_NEAR(beside.y, 2.0, 1e-9);
  EXPECT_NEAR(path.poseAt(-4.0, 0.0).x, -4.0, 1e-9);
  EXPECT_NEAR(path.poseAt(500.0, 0.0).x, 500.0, 1e-6);
}

TEST(SampledPath, AnArcDecaysToAStraightLine) {
  const SampledPath path({5, 6, 0.3}, 0.05, 20.0, 200.0);
  EXPECT_NEAR(path.poseAt(0.0, 0.0).x, 5.0, 1e-9);
  EXPECT_NEAR(path.poseAt(190.0, 0.0).yaw - 0.3, 0.05 * 20.0, 0.01);
  EXPECT_NEAR(path.poseAt(10.0, 0.0).yaw - 0.3, 1.0 - std::exp(-0.5), 0.01);
}

TEST(EgoNow, DerivesPastSpeedsAndTurnRate) {
  Track ego{kEgoId, AgentClass::kCar, kEgoSize, {}};
  const double distances[] = {0.0, 1.0, 3.0, 6.0, 10.0};
  for (int i = 0; i < 5; ++i) {
    ego.states.push_back({kNow + 0.5 * (i - 4), {distances[i], 0, 0.01 * i * i}, {99.0, 0.0}});
  }
  const EgoNow now = egoNow(ego);
  const double speeds[] = {8.0, 6.0, 4.0, 2.0, 2.0};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(now.past_speeds[i], speeds[i], 1e-9) << i;
  EXPECT_NEAR(now.turn_rate, 0.07 / 0.5, 1e-9);
}

TEST(EgoNow, UsesAShortHistory) {
  Track ego{kEgoId, AgentClass::kCar, kEgoSize, {}};
  ego.states.push_back({kNow - 5.0, {-500.0, 0, 0}, {99.0, 0.0}});  // before a gap
  ego.states.push_back({kNow - 0.4, {0.0, 0, 0.1}, {99.0, 0.0}});
  ego.states.push_back({kNow, {4.0, 0, 0.12}, {99.0, 0.0}});
  const EgoNow now = egoNow(ego);
  for (const double speed : now.past_speeds) EXPECT_NEAR(speed, 10.0, 1e-9);
  EXPECT_NEAR(now.turn_rate, 0.02 / 0.4, 1e-9);
}

TEST(EgoNow, ReversingIsNegativeAndASingleStateStands) {
  EXPECT_NEAR(egoAt({0, 0, 1.0}, -3.0).past_speeds[0], -3.0, 1e-9);
  Track lone{kEgoId, AgentClass::kCar, kEgoSize, {{kNow, {1, 2, 3}, {5.0, 0.0}}}};
  EXPECT_EQ(egoNow(lone).past_speeds[0], 0.0);
  lone.states.clear();
  EXPECT_THROW(egoNow(lone), std::invalid_argument);
}

TEST(EgoPaths, IncludeEveryBranchAndThePathWithoutLanes) {
  const LaneIndex lanes(junction());
  const auto paths = egoPaths(egoAt({-20, 0, 0}, 6.0), lanes, kHorizon);
  ASSERT_EQ(paths.size(), 3u);
  EXPECT_NEAR(sumOf(paths), 1.0, 1e-12);
  EXPECT_TRUE(paths[0].on_lanes);
  EXPECT_FALSE(paths[2].on_lanes);
  EXPECT_NEAR(paths[0].ahead.bend_turn, 0.0, 1e-6);
  EXPECT_NEAR(paths[1].ahead.bend_turn, M_PI_2, 0.01);
  EXPECT_GT(paths[0].weight, paths[1].weight);
  EXPECT_GT(paths[1].weight, 0.1);
}

TEST(EgoPaths, ATurningEgoTakesTheTurn) {
  Track ego{kEgoId, AgentClass::kCar, kEgoSize, {}};
  for (int i = -4; i <= 0; ++i) {  // on the quarter circle at 5 m/s, now 6 m into it
    const double angle = (6.0 + 2.5 * i) / 12.0;
    const Pose2 pose = angle > 0.0 ? Pose2{12 * std::sin(angle), 12 - 12 * std::cos(angle), angle}
                                   : Pose2{12 * angle, 0.0, 0.0};
    ego.states.push_back({kNow + 0.5 * i, pose, Vector2::Zero()});
  }
  const auto paths = egoPaths(egoNow(ego), LaneIndex(junction()), kHorizon);
  const EgoPath* best = &paths.front();
  for (const EgoPath& path : paths) best = path.weight > best->weight ? &path : best;
  EXPECT_TRUE(best->on_lanes);
  EXPECT_GT(best->line.poseAt(30.0, 0.0).yaw, 1.4);
  EXPECT_GT(best->weight, 0.8);
}

TEST(EgoPaths, EqualPathsAreMerged) {
  auto map = junction();
  map->lanes.push_back(straightLane("twin", {-200.0, 0.1}, {200.0, 0.1}));
  const LaneIndex lanes(map);
  EXPECT_EQ(egoPaths(egoAt({-20, 0, 0}, 6.0), lanes, kHorizon).size(), 3u);
}

TEST(EgoPaths, TheFollowedPathIsTheNearestToTheTrack) {
  const auto paths = egoPaths(egoAt({-20, 0, 0}, 6.0), LaneIndex(junction()), kHorizon);
  EXPECT_EQ(&followedPath(paths, {{-10, 0}, {9, 4}, {12, 20}}), &paths[1]);
  EXPECT_EQ(&followedPath(paths, {{-10, 0}, {9, 0}}), &paths[0]);
}

class VehicleAhead : public testing::Test {
 protected:
  RoadAhead with(Track agent) {
    const EgoNow ego = egoAt({-50, 0, 0}, 10.0);
    const auto paths = egoPaths(ego, LaneIndex(junction()), kHorizon);
    return roadAhead(
        paths.front(), ego,
        snapshotOf(pastTrack(kEgoId, kEgoSize, {-50, 0, 0}, 10.0), {std::move(agent)}, junction()));
  }
};

TEST_F(VehicleAhead, IsDescribedByGapAndClosingSpeed) {
  // Middles 24 m apart: 19.658 m between bumpers; 10 m/s against 4 m/s; 2 m + 1.2 s is wished.
  const RoadAhead ahead = with(pastTrack("lead", kCarSize, {-26, 0.3, 0}, 4.0));
  const double gap = 24.0 - 0.5 * (kEgoSize.length + kCarSize.length);
  EXPECT_NEAR(ahead.closing, 6.0 / gap, 0.02);
  EXPECT_NEAR(ahead.headway, 14.0 / gap, 0.02);
}

TEST_F(VehicleAhead, ExcludesAgentsBesideBehindCrossingAndPedestrians) {
  EXPECT_EQ(with(pastTrack("beside", kCarSize, {-26, 3.5, 0}, 4.0)).headway, 0.0);
  EXPECT_EQ(with(pastTrack("behind", kCarSize, {-70, 0, 0}, 4.0)).headway, 0.0);
  EXPECT_EQ(with(pastTrack("crossing", kCarSize, {-26, 0, M_PI_2}, 4.0)).headway, 0.0);
  EXPECT_EQ(with(pastTrack("far", kCarSize, {40, 0, 0}, 4.0)).headway, 0.0);
  Track pedestrian = pastTrack("pedestrian", {0.6, 0.6}, {-26, 0, 0}, 1.0);
  pedestrian.agent_class = AgentClass::kPedestrian;
  EXPECT_EQ(with(pedestrian).headway, 0.0);
  Track gone = pastTrack("gone", kCarSize, {-26, 0, 0}, 4.0);
  gone.states.pop_back();
  EXPECT_EQ(with(gone).headway, 0.0);
}

}  // namespace
}  // namespace forge
