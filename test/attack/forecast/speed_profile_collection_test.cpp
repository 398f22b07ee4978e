#include "collision_forge/attack/forecast/speed_profile_collection.h"

#include <gtest/gtest.h>

#include "attack/search/test_scenes.h"

namespace forge {
namespace {

/// Ten seconds eastbound at 8 m/s behind a car at 5 m/s.
Scene followingScene() {
  Scene scene;
  scene.name = "following";
  scene.map = twoLaneRoad();
  scene.ego = straightTrack(kEgoId, kEgoSize, {-80, 0, 0}, 8.0, 0.0, 0.0, 10.0);
  scene.agents = {straightTrack("lead", kCarSize, {-40, 0, 0}, 5.0, 0.0, 0.0, 10.0)};
  for (int i = 0; i <= 20; ++i) scene.frame_times.push_back(0.5 * i);
  return scene;
}

const EgoPathOptions kOptions = shippedEgoFutureOptions().paths;

TEST(CollectSpeedProfiles, ReturnsARowPerFrameExceptTheFirst) {
  const Scene scene = followingScene();
  const auto rows = collectSpeedProfiles(scene, LaneIndex(scene.map), kOptions);
  ASSERT_EQ(rows.size(), 20u);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].scene, "following");
    EXPECT_EQ(rows[i].frame, static_cast<int>(i) + 1);
    EXPECT_NEAR(rows[i].speed, 8.0, 1e-9);
    EXPECT_NEAR(rows[i].ahead.bend_turn, 0.0, 1e-9);
  }
  const double gap = 40.0 - 0.5 * 3.0 - 0.5 * (kEgoSize.length + kCarSize.length);
  EXPECT_NEAR(rows[0].ahead.closing, 3.0 / gap, 0.01);
  EXPECT_GT(rows[19].ahead.headway, rows[0].ahead.headway);
}

TEST(CollectSpeedProfiles, SkipsAFrameNumberWhereFramesAreMissing) {
  Scene scene = followingScene();
  scene.frame_times.erase(scene.frame_times.begin() + 5, scene.frame_times.begin() + 8);
  const auto rows = collectSpeedProfiles(scene, LaneIndex(scene.map), kOptions);
  ASSERT_EQ(rows.size(), 17u);
  EXPECT_EQ(rows[3].frame, 4);
  EXPECT_EQ(rows[4].frame, 6);
  EXPECT_EQ(rows[5].frame, 7);
}

TEST(CollectSpeedProfiles, DescribesThePathThatTheEgoFollowed) {
  Scene scene = followingScene();
  auto map = emptyMap();
  map->lanes = {straightLane("in", {-200, 0}, {-40, 0}, {"on", "left"}),
                straightLane("on", {-40, 0}, {200, 0}), straightLane("left", {-40, 0}, {60, 60})};
  scene.map = map;
  const auto straight = collectSpeedProfiles(scene, LaneIndex(map), kOptions);
  EXPECT_NEAR(straight[2].ahead.bend_turn, 0.0, 1e-6);
  for (AgentState& state : scene.ego.states) {
    if (state.pose.x > -40) state.pose = {state.pose.x, 0.6 * (state.pose.x + 40), 0.54};
  }
  const auto turned = collectSpeedProfiles(scene, LaneIndex(map), kOptions);
  EXPECT_NEAR(turned[2].ahead.bend_turn, 0.54, 0.01);
}

}  // namespace
}  // namespace forge
