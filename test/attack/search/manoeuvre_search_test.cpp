#include "collision_forge/attack/search/manoeuvre_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>

#include "attack/search/test_scenes.h"
#include "collision_forge/attack/search/generate_collision.h"
#include "collision_forge/attack/search/realizer.h"
#include "collision_forge/attack/verify/drive_check.h"
#include "collision_forge/attack/verify/verification.h"

namespace forge {
namespace {

/// The ego drives east, the attackers are given; everything is known.
class ManoeuvreSearchTest : public testing::Test {
 protected:
  void scene(std::shared_ptr<LaneMap> map, const Pose2& ego, double ego_speed,
             const std::vector<Track>& attackers) {
    map_ = std::move(map);
    snapshot_ = snapshotOf(pastTrack("ego", kEgoSize, ego, ego_speed), attackers, map_);
    recorded_.ego = futureTrack("ego", kEgoSize, ego, ego_speed);
    recorded_.agents.clear();
  }

  Attack ask(CollisionType type, double tta = 4.0) const {
    CollisionRequest request = believableRequestFor(type, tta);
    request.mode = Mode::kReplay;
    request.choice = choice_;
    request.departure_time = departure_time_;
    const Moment moment{snapshot_, recorded_, std::make_shared<const LaneIndex>(map_)};
    return generateCollision(searchMethod(options_), moment, request, options_.prediction);
  }

  /// Requests an attack and checks the properties of every believable attack.
  Attack expectAttack(CollisionType type, double tta = 4.0) const {
    const Attack answer = ask(type, tta);
    EXPECT_EQ(answer.status.code, StatusCode::kOk)
        << toString(answer.status.code) << ": " << answer.status.message;
    if (answer.status.code != StatusCode::kOk) return answer;
    EXPECT_TRUE(answer.report.verified());
    EXPECT_EQ(answer.report.unbelievable, "");
    EXPECT_GE(answer.report.road.on_lane, options_.verification.believability.min_on_lane);
    EXPECT_GE(answer.report.manoeuvre_begin, kNow);
    EXPECT_LE(answer.report.manoeuvre_begin, answer.report.contact_time);
    return answer;
  }

  const AttackOptions options_ = shippedOptions();
  std::shared_ptr<LaneMap> map_;
  AttackerChoice choice_ = AttackerChoice::kAny;
  std::optional<Range> departure_time_;
  Snapshot snapshot_;
  Future recorded_;
};

TEST_F(ManoeuvreSearchTest, ALeaderBrakesOrIsSlow) {
  scene(twoLaneRoad(), {0.0, 0.0, 0.0}, 9.0, {pastTrack("lead", kCarSize, {18.0, 0.2, 0.0}, 9.0)});
  const Attack answer = expectAttack(CollisionType::kRearEnd);
  EXPECT_EQ(answer.report.ego_side, Side::kFront);
  EXPECT_LT(answer.trajectory.points[40].speed, 9.0);
}

TEST_F(ManoeuvreSearchTest, AFollowerCloses) {
  scene(twoLaneRoad(), {0.0, 0.0, 0.0}, 7.0, {pastTrack("back", kCarSize, {-22.0, 0.0, 0.0}, 8.0)});
  const Attack answer = expectAttack(CollisionType::kRearEnd);
  EXPECT_EQ(answer.report.manoeuvre, Manoeuvre::kFollowerCloses);
}

TEST_F(ManoeuvreSearchTest, ANeighbourCutsInLate) {
  auto map = twoLaneRoad();
  map->lanes.push_back(straightLane("next", {-200.0, -3.5}, {200.0, -3.5}));
  map->drivable_area.push_back(rectangle(-200.0, -5.25, 200.0, -1.75));
  scene(map, {0.0, 0.0, 0.0}, 9.0, {pastTrack("next", kCarSize, {-4.0, -3.4, 0.0}, 9.5)});
  const Attack answer = expectAttack(CollisionType::kLaneChange);
  EXPECT_EQ(answer.report.manoeuvre, Manoeuvre::kCutIn);
  for (const TrajectoryPoint& point : answer.trajectory.points) {
    if (point.time > answer.report.manoeuvre_begin) break;
    EXPECT_NEAR(point.pose.y, -3.4, 0.35) << "keeps its lane until then";
  }
}

TEST_F(ManoeuvreSearchTest, ANeighbourCutsInAfterAnIslandNotOverIt) {
  constexpr double kIslandEnd = 38.0;  // m; the ego is there 0.2 s after the requested time
  auto map = twoLaneRoad();
  map->lanes.push_back(straightLane("next", {-200.0, -5.5}, {200.0, -5.5}));
  map->drivable_area.push_back(rectangle(-200.0, -7.25, 200.0, -3.75));
  map->drivable_area.push_back(rectangle(-200.0, -3.75, 20.0, -1.75));
  map->drivable_area.push_back(rectangle(kIslandEnd, -3.75, 200.0, -1.75));
  scene(map, {0.0, 0.0, 0.0}, 9.0, {pastTrack("next", kCarSize, {-4.0, -5.4, 0.0}, 9.5)});
  const Attack answer = expectAttack(CollisionType::kLaneChange);
  EXPECT_EQ(answer.report.road.on_island, 0.0);
}

TEST_F(ManoeuvreSearchTest, AParkedCarPullsOut) {
  auto map = twoLaneRoad();
  map->drivable_area.push_back(rectangle(-200.0, -5.25, 200.0, -1.0));
  scene(map, {0.0, 0.0, 0.0}, 8.0, {pastTrack("parked", kCarSize, {33.0, -2.6, 0.0}, 0.0)});
  const Attack answer = expectAttack(CollisionType::kLaneChange);
  EXPECT_EQ(answer.report.ego_side, Side::kRight);
  EXPECT_EQ(answer.trajectory.points.front().speed, 0.0);
  EXPECT_LT(answer.trajectory.points[5].speed, 0.2) << "waits until the ego is near";
}

TEST_F(ManoeuvreSearchTest, AParkedCarPullsOutAtTheRequestedTime) {
  auto map = twoLaneRoad();
  map->drivable_area.push_back(rectangle(-200.0, -5.25, 200.0, -1.0));
  scene(map, {0.0, 0.0, 0.0}, 8.0, {pastTrack("parked", kCarSize, {30.0, -2.6, 0.0}, 0.0)});
  choice_ = AttackerChoice::kExisting;
  for (const double departure : {0.5, 1.0, 1.5}) {
    departure_time_ = Range{departure - 0.25, departure + 0.25};
    const Attack answer = expectAttack(CollisionType::kLaneChange);
    EXPECT_NEAR(answer.report.conditions.departure_time, departure, 0.25 + 1e-6);
  }
}

TEST_F(ManoeuvreSearchTest, AMovingCarHasNoDepartureTime) {
  choice_ = AttackerChoice::kExisting;
  departure_time_ = Range{0.5, 1.5};
  scene(twoLaneRoad(), {0.0, 0.0, 0.0}, 7.0, {pastTrack("back", kCarSize, {-22.0, 0.0, 0.0}, 8.0)});
  const Status status = ask(CollisionType::kRearEnd).status;
  EXPECT_EQ(status.code, StatusCode::kNoCandidate);
  EXPECT_NE(status.message.find("stands at t0 as departure_time requires"), std::string::npos)
      << status.message;
}

TEST_F(ManoeuvreSearchTest, AnOncomingCarCrossesTheCentreLine) {
  scene(twoLaneRoad(), {0.0, 0.0, 0.0}, 8.0,
        {pastTrack("oncoming", kCarSize, {70.0, 3.5, M_PI}, 8.5)});
  const Attack answer = expectAttack(CollisionType::kOppositeDirection);
  EXPECT_EQ(answer.report.manoeuvre, Manoeuvre::kCentreLineCrossing);
}

TEST_F(ManoeuvreSearchTest, ACrossingCarDoesNotStop) {
  scene(fourWayJunction(), {-34.0, -1.75, 0.0}, 8.0,
        {pastTrack("cross", kCarSize, {-1.75, 36.0, -M_PI_2}, 8.0)});
  const Attack answer = expectAttack(CollisionType::kJunctionCrossing);
  EXPECT_EQ(answer.report.manoeuvre, Manoeuvre::kStraightCrossing);
}

TEST_F(ManoeuvreSearchTest, RejectsACrossingWithoutACrossingLane) {
  scene(twoLaneRoad(), {0.0, 0.0, 0.0}, 8.0,
        {pastTrack("cross", kCarSize, {32.0, 30.0, -M_PI_2}, 8.0)});
  EXPECT_EQ(ask(CollisionType::kJunctionCrossing).status.code, StatusCode::kRoadDoesNotAllow);
}

TEST_F(ManoeuvreSearchTest, ABusDrivesAsABusCan) {
  Track bus = pastTrack("bus", {12.0, 2.9}, {-20.0, 0.0, 0.0}, 9.0);
  bus.agent_class = AgentClass::kBus;
  scene(twoLaneRoad(), {0.0, 0.0, 0.0}, 6.0, {bus});
  const Attack answer = expectAttack(CollisionType::kRearEnd);
  const DriveLimits limits = driveLimitsOf(bus, options_.verification);
  EXPECT_FALSE(findBrokenDrive(answer.trajectory.points, driveStateNow(bus, options_.verification),
                               answer.report.contact_time, limits));
}

TEST_F(ManoeuvreSearchTest, FindsTheOnlyPossibleAttackerAmongMany) {
  // All but the leader are too far away to be there in time.
  std::vector<Track> others;
  for (int i = 0; i <= kDrafted; ++i) {
    others.push_back(
        pastTrack("ahead " + std::to_string(i), kCarSize, {40.0 + 6.0 * i, 0.0, 0.0}, 14.0));
  }
  ASSERT_LT(others.back().states.back().pose.x, options_.prediction.candidate_radius);
  others.push_back(pastTrack("lead", kCarSize, {18.0, 0.2, 0.0}, 9.0));
  scene(twoLaneRoad(), {0.0, 0.0, 0.0}, 9.0, others);
  EXPECT_EQ(expectAttack(CollisionType::kRearEnd).trajectory.attacker_id, "lead");
}

}  // namespace
}  // namespace forge
