#include "collision_forge/study/dataset/clip_search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "attack/search/test_scenes.h"
#include "collision_forge/base/scene/track.h"
#include "collision_forge/io/collide/collide_export.h"
#include "collision_forge/io/scenarios/scenario_file.h"
#include "collision_forge/study/settings/study_config.h"

namespace forge {
namespace {

using testing::HasSubstr;

constexpr double kTta = 4.0;  // s

/// The ego drives east at 8 m/s on a road; the agent `behind` is 15 m behind it at 9 m/s.
class ClipSearch : public testing::Test {
 protected:
  ClipSearch() {
    config_.dataset.choice = AttackerChoice::kExisting;
    indexed_.scene.name = "scene-0007";
    for (int i = 0; i <= 30; ++i) indexed_.scene.frame_times.push_back(kNow - 5.0 + 0.5 * i);
    indexed_.scene.ego = track(kEgoId, kEgoSize, {0.0, 0.0, 0.0}, 8.0);
    indexed_.scene.agents = {track("behind", kCarSize, {-15.0, 0.0, 0.0}, 9.0)};
    setMap(twoLaneRoad());
  }

  static Track track(const std::string& id, const BoxSize& size, const Pose2& now, double speed) {
    return straightTrack(id, size, now, speed, kNow, kNow - 5.0, kNow + 10.0);
  }

  void setMap(const std::shared_ptr<LaneMap>& map) {
    if (map->location.empty()) map->location = "town";
    indexed_.scene.map = map;
    indexed_.lanes = std::make_shared<const LaneIndex>(map);
  }

  SceneRequest asked(CollisionType type = CollisionType::kRearEnd, std::uint64_t seed = 1) const {
    SceneRequest request{"scene-0007", kNow, {}};
    request.request.type = type;
    request.request.tta = kTta;
    request.request.mode = Mode::kReplay;
    request.request.seed = seed;
    return request;
  }

  Realization found(const SceneRequest& request) const {
    return findClip(request, indexed_, config_, config_.dataset);
  }

  void expectRefusal(StatusCode code, const std::string& part) const {
    const Realization answer = found(asked());
    EXPECT_EQ(toString(answer.status.code), std::string(toString(code)));
    EXPECT_THAT(answer.status.message, HasSubstr(part));
    EXPECT_TRUE(answer.trajectory.points.empty());
  }

  StudyConfig config_ = loadStudyConfig(COLLISION_FORGE_SOURCE_DIR "/config");
  IndexedScene indexed_;
};

TEST_F(ClipSearch, AClipHasContactAtTheTargetTimeAndDrawnHeading) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const SceneRequest request = asked(CollisionType::kRearEnd, seed);
    const Realization answer = found(request);
    ASSERT_EQ(answer.status.code, StatusCode::kOk) << answer.status.message;
    EXPECT_EQ(answer.trajectory.attacker_id, "behind");
    EXPECT_TRUE(answer.report.verified());
    EXPECT_NEAR(answer.report.contact_time, kNow + kTta, config_.dataset.time_tolerance);
    const double drawn =
        drawnHeading(request.request, config_.crash.types.at(CollisionType::kRearEnd));
    EXPECT_NEAR(std::abs(answer.report.relative_heading), drawn,
                2.0 * config_.dataset.heading_spread);
  }
}

TEST_F(ClipSearch, AnAddedVehicleMakesAClipWithoutCandidates) {
  config_.dataset.choice = AttackerChoice::kAny;
  indexed_.scene.agents.clear();
  const Realization answer = found(asked());
  ASSERT_EQ(answer.status.code, StatusCode::kOk) << answer.status.message;
  EXPECT_TRUE(answer.trajectory.isAdded());
  EXPECT_TRUE(answer.report.believable());
  EXPECT_EQ(answer.trajectory.past.front().time, indexed_.scene.frame_times.front());
}

TEST_F(ClipSearch, TheHeadingStaysWithinTheSpread) {
  config_.dataset.heading_spread = 0.02;
  const TypeDefinition& type = config_.crash.types.at(CollisionType::kLaneChange);
  auto map = twoLaneRoad();
  map->lanes[1] = straightLane("east_too", {-200.0, 3.5}, {200.0, 3.5});
  setMap(map);
  indexed_.scene.agents = {track("beside", kCarSize, {-8.0, 3.5, 0.0}, 9.0)};
  std::set<int> degrees;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const SceneRequest request = asked(CollisionType::kLaneChange, seed);
    const Realization answer = found(request);
    if (answer.status.code != StatusCode::kOk) continue;
    const double drawn = std::clamp(drawnHeading(request.request, type), type.min_heading + 0.02,
                                    type.max_heading - 0.02);
    EXPECT_NEAR(std::abs(answer.report.relative_heading), drawn, 0.0201);
    degrees.insert(static_cast<int>(std::abs(answer.report.relative_heading) * 180.0 / M_PI));
  }
  EXPECT_GT(degrees.size(), 3U);
}

TEST_F(ClipSearch, TheTrajectoryContinuesTheRecordedState) {
  const Realization answer = found(asked());
  ASSERT_EQ(answer.status.code, StatusCode::kOk);
  const TrajectoryPoint& start = answer.trajectory.points.front();
  EXPECT_NEAR(start.time, kNow, 1e-9);
  EXPECT_NEAR(start.pose.x, -15.0, 1e-6);
  EXPECT_NEAR(start.pose.y, 0.0, 1e-6);
  EXPECT_NEAR(start.speed, 9.0, 1e-3);
}

TEST_F(ClipSearch, AVehicleWithoutAFrameOfTheHistoryIsNoCandidate) {
  auto& states = indexed_.scene.agents.front().states;
  states.erase(states.begin() + 3);  // 3.5 s before now, the clip's first frame
  expectRefusal(StatusCode::kNoCandidate, "in all 8 frames");
}

TEST_F(ClipSearch, AnOffRoadAttackIsRejected) {
  auto map = twoLaneRoad();
  map->drivable_area = {rectangle(100.0, -1.75, 200.0, 5.25)};
  setMap(map);
  expectRefusal(StatusCode::kNoAttackWithinLimits, "leaves the road");
}

TEST_F(ClipSearch, AnAttackNotVisibleInTheClipIsRejected) {
  // In the clip the long bus has the size of a car, which is 6.65 m shorter at its front.
  indexed_.scene.agents = {track("behind", {18.0, 2.5}, {-22.0, 0.0, 0.0}, 9.0)};
  expectRefusal(StatusCode::kNoAttackWithinLimits, "the clip does not meet these measures of the ");
}

TEST_F(ClipSearch, AnUnknownFrameAndALateImpactHaveAStatus) {
  SceneRequest request = asked();
  request.now += 0.2;
  EXPECT_EQ(found(request).status.code, StatusCode::kNoScene);
  request.now = indexed_.scene.frame_times.back();
  EXPECT_EQ(found(request).status.code, StatusCode::kBeyondRecording);
}

TEST(NarrowedBand, IsAroundTheHeadingWithinTheBandOfTheType) {
  const TypeDefinition type{0.2, 0.5, 0.3, 0.0, 1.0};
  const auto expect = [&](double heading, double spread, double low, double high) {
    const TypeDefinition narrowed = narrowedAbout(type, heading, spread);
    EXPECT_DOUBLE_EQ(narrowed.min_heading, low);
    EXPECT_DOUBLE_EQ(narrowed.max_heading, high);
    EXPECT_DOUBLE_EQ(narrowed.nominal_heading, heading);
    EXPECT_DOUBLE_EQ(narrowed.max_approach, 1.0);
  };
  expect(0.35, 0.05, 0.3, 0.4);
  expect(0.21, 0.05, 0.2, 0.3);
  expect(0.5, 0.05, 0.4, 0.5);
  expect(0.25, 1.0, 0.2, 0.5);
}

TEST(DrawnHeading, IsAnywhereInTheBand) {
  const TypeDefinition type{0.2, 0.5, 0.3, 0.0, 1.0};
  double sum = 0.0;
  double least = 1.0;
  double most = 0.0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    CollisionRequest request;
    request.tta = kTta;
    request.mode = Mode::kReplay;
    request.seed = seed;
    const double heading = drawnHeading(request, type);
    sum += heading;
    least = std::min(least, heading);
    most = std::max(most, heading);
  }
  EXPECT_NEAR(sum / 1000.0, 0.35, 0.014);  // five deviations of the mean
  EXPECT_GE(least, 0.2);
  EXPECT_LT(least, 0.21);
  EXPECT_LE(most, 0.5);
  EXPECT_GT(most, 0.49);
}

}  // namespace
}  // namespace forge
