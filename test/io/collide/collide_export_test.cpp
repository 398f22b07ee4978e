#include "collision_forge/io/collide/collide_export.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/scene/shipped_limits.h"
#include "collision_forge/io/collide/collide_set.h"
#include "collision_forge/study/evaluation/clip_attackers.h"
#include "collision_forge/study/evaluation/published.h"
#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

using testing::ElementsAre;

constexpr double kDegree = M_PI / 180.0;
constexpr double kStart = 1533153458.0;  // s, time of the recording's first frame
constexpr int kFrames = 20;
constexpr int kNow = 9;  // frame of the recording
constexpr int kFirst = kNow - kCollideNowFrame;
constexpr double kTta = 4.0;  // s
constexpr int kCollisionFrame = 15;
constexpr double kEgoSpeed = 10.0;     // m/s, along x
constexpr double kAttackSpeed = 14.0;  // m/s, from t0 on
constexpr double kGap = 20.0;          // m between the box centres at t0, the attacker behind

/// Every second frame is late, so that neither times nor positions are round numbers.
double frameTime(int frame) { return kStart + 0.5 * frame + (frame % 2 == 0 ? 0.04 : 0.0); }

double xOfEgo(double time) { return 100.0 + kEgoSpeed * (time - frameTime(kNow)); }

Track agent(const std::string& id, AgentClass agent_class, int first, int last, double y) {
  Track track{id, agent_class, {4.5, 1.8}, {}};
  for (int frame = first; frame <= last; ++frame) {
    track.states.push_back(
        {frameTime(frame), {xOfEgo(frameTime(frame)) - kGap, y, 0.0}, {kEgoSpeed, 0.0}});
  }
  return track;
}

/// The ego, an attacker behind it, a car that is present in some frames, a car that appears after
/// the clip, and a pedestrian.
Scene recording() {
  Scene scene;
  scene.name = "scene-0042";
  auto map = std::make_shared<LaneMap>();
  map->location = "embedded-right";
  scene.map = map;
  for (int frame = 0; frame < kFrames; ++frame) scene.frame_times.push_back(frameTime(frame));
  scene.ego = {kEgoId, AgentClass::kCar, {4.0, 1.7}, {}};
  for (double time = kStart; time < frameTime(kFrames); time += 0.1) {
    scene.ego.states.push_back({time, {xOfEgo(time), 50.0, 0.0}, {kEgoSpeed, 0.0}});
  }
  scene.agents = {agent("walker", AgentClass::kPedestrian, 0, kFrames - 1, 70.0),
                  agent("late", AgentClass::kCar, kFirst + kCollisionFrame + 1, kFrames - 1, 60.0),
                  agent("guest", AgentClass::kBus, kNow - 1, kNow + 1, 60.0),
                  agent("attacker", AgentClass::kCar, 0, kNow + 2, 50.0)};
  return scene;
}

/// The attacker hits the ego's rear; trajectory from t0 on.
Scenario attack() {
  Scenario scenario;
  scenario.asked = {"scene-0042", frameTime(kNow), {}};
  scenario.asked.request.type = CollisionType::kRearEnd;
  scenario.asked.request.tta = kTta;
  scenario.answer.trajectory.attacker_id = "attacker";
  for (int i = 0; i <= 60; ++i) {
    const double elapsed = 0.1 * i;
    scenario.answer.trajectory.points.push_back({frameTime(kNow) + elapsed,
                                                 {100.0 - kGap + kAttackSpeed * elapsed, 50.0, 0.0},
                                                 kAttackSpeed + elapsed,
                                                 0.0,
                                                 0.0});
  }
  scenario.answer.report.relative_heading = -7.25 * kDegree;
  scenario.answer.report.ego_at_contact = {138.0, 50.0, 0.0};
  scenario.answer.report.attacker_at_contact = {134.0, 50.0, 0.0};
  return scenario;
}

CollideClip clipOf(const Scenario& scenario, const Scene& scene = recording()) {
  return std::get<CollideClip>(toCollideClip(scenario, scene, 3));
}

ClipObstacle obstacleOf(const Scenario& scenario, const Scene& scene = recording()) {
  return std::get<ClipObstacle>(toCollideClip(scenario, scene, 3));
}

int placementAt(CollisionType type, const Pose2& ego, const Pose2& attacker) {
  Scenario scenario = attack();
  scenario.asked.request.type = type;
  scenario.answer.report.ego_at_contact = ego;
  scenario.answer.report.attacker_at_contact = attacker;
  scenario.answer.report.relative_heading = angleBetween(ego.yaw, attacker.yaw);
  return clipOf(scenario).placement;
}

TEST(CollideExport, NameHasEveryField) {
  // n = (15 - 8) / 12.
  EXPECT_EQ(clipOf(attack()).name,
            "data_hcis_collision-forge_trainval_embedded-right_RE_scene-0042_"
            "4-3-0.5833333333333334-15_7.25_attacker");
}

TEST(CollideExport, PlacementFollowsTypeAndContact) {
  const Pose2 ego{10.0, 20.0, M_PI_2};  // heads along y: its left is towards -x
  const auto at = [&](double x, double y, double turn) {
    return Pose2{x, y, wrapAngle(ego.yaw + turn)};
  };
  EXPECT_EQ(placementAt(CollisionType::kLaneChange, ego, at(8.0, 22.0, -0.3)), 0);
  EXPECT_EQ(placementAt(CollisionType::kLaneChange, ego, at(12.0, 22.0, 0.3)), 1);
  EXPECT_EQ(placementAt(CollisionType::kJunctionCrossing, ego, at(7.0, 20.0, -M_PI_2)), 2);
  EXPECT_EQ(placementAt(CollisionType::kJunctionCrossing, ego, at(13.0, 20.0, M_PI_2)), 3);
  EXPECT_EQ(placementAt(CollisionType::kLtap, ego, at(7.0, 20.0, -M_PI_2)), 2);
  EXPECT_EQ(placementAt(CollisionType::kLtap, ego, at(13.0, 20.0, M_PI_2)), 3);
  EXPECT_EQ(placementAt(CollisionType::kRearEnd, ego, at(10.0, 16.0, 0.1)), 4);
  EXPECT_EQ(placementAt(CollisionType::kOppositeDirection, ego, at(10.0, 24.0, 3.1)), 5);
}

TEST(CollideExport, CollisionFrameIsTheNearestToTheTta) {
  Scenario scenario = attack();
  for (const auto& [tta, frame] : {std::pair(0.5, 8), {3.74, 14}, {3.76, 15}, {4.24, 15}}) {
    scenario.asked.request.tta = tta;
    EXPECT_EQ(clipOf(scenario).collision_frame, frame) << tta;
  }
}

TEST(CollideExport, AddedAttackerFollowsItsPastUpToT0) {
  Scenario scenario = attack();
  AttackerTrajectory& trajectory = scenario.answer.trajectory;
  trajectory.attacker_id = "added";
  EXPECT_EQ(obstacleOf(scenario), ClipObstacle::kAttackerMissing);
  trajectory.past = agent("added", AgentClass::kCar, 0, kNow, 55.0).states;
  const CollideClip clip = clipOf(scenario);
  EXPECT_EQ(clip.attacker_id, "added");
  for (int frame = 0; frame <= kCollideNowFrame; ++frame) {
    const CollideState& state = *clip.attacker().frames[frame];
    EXPECT_NEAR(state.pose.x, 100.0 - kGap + kEgoSpeed * (clip.times[frame] - clip.now()), 1e-5);
    EXPECT_EQ(state.pose.y, 55.0);
  }
  trajectory.past.erase(trajectory.past.begin(), trajectory.past.begin() + kFirst + 1);
  EXPECT_EQ(obstacleOf(scenario), ClipObstacle::kAttackerMissing);
}

TEST(CollideExport, OtherVehiclesAppearInTheirRecordedFrames) {
  const CollideClip clip = clipOf(attack());
  std::vector<std::string> ids;
  for (const CollideTrack& track : clip.tracks) ids.push_back(track.id);
  EXPECT_THAT(ids, ElementsAre("attacker", "ego", "guest"));
  for (int frame = 0; frame <= kCollisionFrame; ++frame) {
    const auto& state = clip.track("guest").frames[frame];
    ASSERT_EQ(state.has_value(), std::abs(frame - kCollideNowFrame) <= 1) << frame;
    if (!state) continue;
    EXPECT_EQ(state->pose.x, xOfEgo(clip.times[frame]) - kGap);
  }
}

TEST(CollideExport, RoundTrippedClipCollidesUnderThePublishedProtocol) {
  const TemporaryFolder folder;
  CollideExporter exporter(folder.path());
  exporter.add(attack(), recording(), 3);
  const auto paths = listCollideClips(folder.path(), "val");
  ASSERT_EQ(paths.size(), 1u);
  const CollideClip clip = readCollideClip(paths[0], shippedLimits());
  EXPECT_EQ(clip.batch, "collision-forge");
  EXPECT_EQ(clip.city, "embedded-right");
  EXPECT_EQ(clip.scene, "scene-0042");
  EXPECT_EQ(clip.type, CollisionType::kRearEnd);
  EXPECT_EQ(clip.placement, 4);
  EXPECT_EQ(clip.variant, 3);
  EXPECT_EQ(clip.collision_frame, kCollisionFrame);
  EXPECT_NEAR(clip.angle, 7.25 * kDegree, 1e-9);
  EXPECT_EQ(clip.attacker_id, "attacker");

  const PublishedOptions options{{4.7, 2.0}, 0.02, 5, 20, 10.0 * kDegree};
  const PublishedOutcome outcome = publishedOutcome(clip, recordedFrames(clip), options);
  ASSERT_TRUE(outcome.isHit());
  EXPECT_TRUE(outcome.similar);
  // The boxes of 4.7 m overlap by 0.18431 m, an IoU of 0.02.
  const double contact = (kGap - 4.7 + 0.18431) / (kAttackSpeed - kEgoSpeed);  // s from now
  EXPECT_NEAR(0.1 * (outcome.step - 5 * kCollideNowFrame), contact, 0.1 + 0.04);
}

/// The recording with another rate: ego and agents in frames `interval` s apart, one of them at t0.
Scene recordedEvery(double interval) {
  Scene scene = recording();
  const double now = frameTime(kNow);
  const int before = static_cast<int>((now - frameTime(0)) / interval);
  const int after = static_cast<int>((frameTime(kFrames - 1) - now) / interval);
  scene.frame_times.clear();
  for (int i = -before; i <= after; ++i) scene.frame_times.push_back(now + interval * i);
  Track& attacker = scene.agents.back();
  attacker.states.clear();
  for (const double time : scene.frame_times) {
    attacker.states.push_back({time, {xOfEgo(time) - kGap, 50.0, 0.0}, {kEgoSpeed, 0.0}});
  }
  return scene;
}

TEST(CollideExport, ARecordingAtAnotherRateIsResampledToTwoHertz) {
  for (const double rate : {3.0, 10.0, 12.0, 25.0}) {
    const CollideClip clip = clipOf(attack(), recordedEvery(1.0 / rate));
    ASSERT_EQ(clip.collision_frame, kCollisionFrame) << rate;
    for (int frame = 0; frame <= kCollisionFrame; ++frame) {
      EXPECT_NEAR(clip.times[frame], frameTime(kNow) + 0.5 * (frame - kCollideNowFrame), 1e-3);
      EXPECT_NEAR(clip.ego().frames[frame]->pose.x, xOfEgo(clip.times[frame]), 1e-5) << rate;
    }
    EXPECT_NEAR(clip.attacker().frames[0]->pose.x, xOfEgo(clip.times[0]) - kGap, 1e-5) << rate;
    EXPECT_NEAR(clip.attacker().frames[kCollisionFrame]->pose.x, 100.0 - kGap + kAttackSpeed * kTta,
                1e-2);
  }
}

TEST(CollideExport, ReportsWhyTheLayoutCannotHoldAnAttack) {
  Scenario early = attack();
  early.asked.now = frameTime(6);
  EXPECT_EQ(obstacleOf(early), ClipObstacle::kShortHistory);

  Scenario late = attack();
  late.asked.request.tta = 0.5 * (kFrames - kNow);
  EXPECT_EQ(obstacleOf(late), ClipObstacle::kNoCollisionFrame);
  late.asked.request.tta = 0.2;
  EXPECT_EQ(obstacleOf(late), ClipObstacle::kNoCollisionFrame);

  for (const int frame : {kFirst, kFirst + kCollisionFrame}) {
    Scene no_ego = recording();
    auto& states = no_ego.ego.states;
    const auto is_there = [&](const AgentState& state) {
      return frame == kFirst ? state.time > frameTime(frame) : state.time < frameTime(frame);
    };
    states.erase(std::remove_if(states.begin(), states.end(),
                                [&](const AgentState& state) { return !is_there(state); }),
                 states.end());
    EXPECT_EQ(obstacleOf(attack(), no_ego), ClipObstacle::kEgoMissing) << frame;
  }

  for (const int frame : {kFirst, kNow}) {
    Scene gap = recording();
    auto& states = gap.agents.back().states;
    states.erase(states.begin() + frame);
    EXPECT_EQ(obstacleOf(attack(), gap), ClipObstacle::kAttackerMissing) << frame;
  }
  Scenario stranger = attack();
  stranger.answer.trajectory.attacker_id = "stranger";
  EXPECT_EQ(obstacleOf(stranger), ClipObstacle::kAttackerMissing);

  Scenario brief = attack();
  brief.answer.trajectory.points.resize(40);  // to 3.9 s
  EXPECT_EQ(obstacleOf(brief), ClipObstacle::kTrajectoryEnds);
  brief = attack();
  brief.answer.trajectory.points.resize(41);
  EXPECT_EQ(clipOf(brief).collision_frame, kCollisionFrame);

  Scene underscore = recording();
  underscore.name = "scene_0042";
  EXPECT_EQ(obstacleOf(attack(), underscore), ClipObstacle::kUnfitName);
}

TEST(CollideExport, ObstaclesAreCountedAndNamed) {
  const TemporaryFolder folder;
  CollideExporter exporter(folder.path());
  exporter.add(attack(), recording(), 0);
  EXPECT_EQ(exporter.complaint(), "");
  Scenario early = attack();
  early.asked.now = frameTime(6);
  exporter.add(early, recording(), 1);
  early.asked.now = frameTime(5);
  exporter.add(early, recording(), 2);
  Scenario stranger = attack();
  stranger.answer.trajectory.attacker_id = "stranger";
  exporter.add(stranger, recording(), 3);
  Scenario refusal = attack();
  refusal.answer.status.code = StatusCode::kNoCandidate;
  exporter.add(refusal, recording(), 4);
  EXPECT_EQ(exporter.clips(), 1);
  EXPECT_EQ(exporter.complaint(),
            "3 of 4 attacks have no clip of COLLIDE's layout: 2 with fewer than 7 frames at 2 Hz "
            "before t0, 1 without the attacker in one of the 7 frames before t0");
  EXPECT_EQ(listCollideClips(folder.path(), "val").size(), 1u);
}

TEST(CollideExport, WritesOnlyMissingClips) {
  const TemporaryFolder folder;
  const auto exportTwo = [&] {
    CollideExporter exporter(folder.path());
    exporter.add(attack(), recording(), 0);
    exporter.add(attack(), recording(), 1);
    EXPECT_EQ(exporter.clips(), 2);
  };
  exportTwo();
  const auto paths = listCollideClips(folder.path(), "val");
  ASSERT_EQ(paths.size(), 2u);
  const std::filesystem::file_time_type old{};
  for (const std::string& path : paths) std::filesystem::last_write_time(path, old);
  // As left by an interruption in the middle of the second clip.
  std::filesystem::rename(paths[1], paths[1] + ".part");
  std::filesystem::resize_file(paths[1] + ".part", 100);
  exportTwo();
  EXPECT_EQ(listCollideClips(folder.path(), "val"), paths);
  EXPECT_EQ(std::filesystem::last_write_time(paths[0]), old);
  EXPECT_NE(std::filesystem::last_write_time(paths[1]), old);
  EXPECT_EQ(readCollideClip(paths[1], shippedLimits()).tracks.size(), 3u);
}

TEST(CollideExport, ClipsOfASplitLieInItsFolder) {
  const TemporaryFolder folder;
  CollideExporter exporter(folder.path(), "test");
  exporter.add(attack(), recording(), 3);
  const auto listed = listCollideClips(folder.path(), "test");
  ASSERT_EQ(listed.size(), 1U);
  EXPECT_EQ(std::filesystem::path(listed.front()).parent_path(),
            CollideExporter::folderIn(folder.path(), "test"));
  EXPECT_THROW(listCollideClips(folder.path(), "val"), CollideError);
}

}  // namespace
}  // namespace forge
