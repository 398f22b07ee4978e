#include "collision_forge/study/generators/traffic_clip.h"

#include <gtest/gtest.h>

#include "attack/search/test_scenes.h"
#include "study/generators/sample_traffic.h"

namespace forge {
namespace {

const CollideOptions kCollide{{4.7, 2.0}, 2.0, 0.1};
constexpr double kRounding = 1e-5;  // m; times since 1970 have 1e-7 s

/// A clip with three other agents: a moving car, a standing one, and one that appears late.
CollideClip clipWithOthers() {
  CollideClip clip = straightClip(CollisionType::kLtap, 90.0, 11, 5.0, {30.0, 3.0, M_PI}, 8.0);
  clip.tracks.push_back(standingClipTrack("standing", {0.0, 6.0, 0.0}, 11));
  clip.tracks.push_back(straightClipTrack("far", {60.0, 6.0, 0.0}, 4.0, 11));
  clip.tracks.push_back(straightClipTrack("near", {10.0, 6.0, 0.0}, 4.0, 11));
  clip.tracks.push_back(straightClipTrack("late", {5.0, 9.0, 0.0}, 4.0, 11));
  for (int frame = 0; frame <= kCollideNowFrame; ++frame) clip.tracks.back().frames[frame].reset();
  return clip;
}

TEST(TrafficOf, OrdersEgoAttackerThenMovingAgentsByDistance) {
  const TrafficClip traffic = trafficOf(clipWithOthers(), kCollide,
                                        withoutLanes(shippedConfig().generators.traffic), nullptr);
  EXPECT_EQ(traffic.scene, "scene-0001");
  EXPECT_EQ(traffic.type, CollisionType::kLtap);
  EXPECT_EQ(traffic.collision_frame, 11);
  ASSERT_EQ(traffic.agents.size(), 4u);
  for (const AgentFrames& frames : traffic.agents) EXPECT_EQ(frames.size(), 12u);
  EXPECT_NEAR(traffic.agents[kEgoAgent][7]->x, 0.0, kRounding);
  EXPECT_NEAR(traffic.agents[kAttackerAgent][7]->x, 30.0, kRounding);
  EXPECT_NEAR(traffic.agents[2][7]->x, 10.0, kRounding);
  EXPECT_NEAR(traffic.agents[3][7]->x, 60.0, kRounding);
  EXPECT_NEAR(traffic.agents[3][11]->x, 68.0, kRounding);
  EXPECT_EQ(traffic.ids, (std::vector<std::string>{kEgoId, "attacker", "near", "far"}));
}

TEST(TrafficOf, KeepsAtMostMaxAgents) {
  TrafficOptions options = withoutLanes(shippedConfig().generators.traffic);
  options.max_agents = 3;
  const TrafficClip traffic = trafficOf(clipWithOthers(), kCollide, options, nullptr);
  ASSERT_EQ(traffic.agents.size(), 3u);
  EXPECT_NEAR(traffic.agents[2][7]->x, 10.0, kRounding);
}

TEST(TrafficOf, HidesTheHistoryOfTheAttacker) {
  CollideClip clip = clipWithOthers();
  const TrafficOptions options = withoutLanes(shippedConfig().generators.traffic);
  const TrafficClip straight = trafficOf(clip, kCollide, options, nullptr);
  for (int frame = 0; frame < kCollideNowFrame; ++frame) {
    clip.tracks[0].frames[frame]->pose = {500.0, 77.0 * frame, 1.0};
  }
  const TrafficClip wild = trafficOf(clip, kCollide, options, nullptr);
  for (int frame = 0; frame <= kCollideNowFrame; ++frame) {
    EXPECT_EQ(straight.agents[kAttackerAgent][frame]->x, wild.agents[kAttackerAgent][frame]->x);
    EXPECT_NEAR(straight.agents[kAttackerAgent][frame]->x, 30.0 + 4.0 * (7 - frame), kRounding);
  }
}

TEST(TrafficOf, ConvertsASnapshotToTheFrameOfTheEgo) {
  const Snapshot snapshot =
      snapshotOf(pastTrack(kEgoId, kEgoSize, {100.0, 50.0, M_PI_2}, 10.0),
                 {pastTrack("attacker", kCarSize, {100.0, 20.0, M_PI_2}, 14.0)}, twoLaneRoad());
  CollisionRequest request = requestFor();
  request.tta = 2.1;
  const TrafficClip traffic = trafficOf(snapshot, "attacker", request,
                                        withoutLanes(shippedConfig().generators.traffic), nullptr);
  EXPECT_EQ(traffic.collision_frame, 11);
  ASSERT_EQ(traffic.agents.size(), 2u);
  ASSERT_EQ(traffic.agents[kAttackerAgent].size(), 8u);
  EXPECT_NEAR(traffic.agents[kAttackerAgent][7]->x, -30.0, kRounding);
  EXPECT_NEAR(traffic.agents[kAttackerAgent][0]->x, -30.0 - 7 * 7.0, kRounding);
  EXPECT_NEAR(traffic.agents[kEgoAgent][0]->x, -7 * 5.0, kRounding);
  EXPECT_THROW(trafficOf(snapshot, "nobody", request,
                         withoutLanes(shippedConfig().generators.traffic), nullptr),
               std::invalid_argument);
}

}  // namespace
}  // namespace forge
