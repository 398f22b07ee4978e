#include "collision_forge/policy/observed_scene.h"

#include <gtest/gtest.h>

#include "attack/test_scenes.h"

namespace forge {
namespace {

constexpr int kFrames = 4;
constexpr double kInterval = 0.5;  // s

Track seenAt(const std::string& id, double time, const Pose2& pose) {
  return {id, AgentClass::kCar, kCarSize, {{time, pose, {0.0, 0.0}}}};
}

class ObservedSceneTest : public testing::Test {
 protected:
  ObservedSceneTest()
      : start_(snapshotOf(pastTrack(kEgoId, kEgoSize, {0.0, 0.0, 0.0}, 6.0),
                          {pastTrack("a", kCarSize, {20.0, 0.0, 0.0}, 4.0)}, twoLaneRoad())),
        scene_(start_, {kEgoSize, 0.0}, kFrames, kInterval) {}

  Snapshot start_;
  ObservedScene scene_;
};

TEST_F(ObservedSceneTest, BeginsAsTheSnapshotDoes) {
  const Snapshot shown = scene_.snapshot();
  EXPECT_EQ(shown.now, kNow);
  EXPECT_EQ(shown.map, start_.map);
  ASSERT_EQ(shown.ego.states.size(), 4u);
  EXPECT_NEAR(shown.ego.states.front().time, kNow - 1.5, 1e-9);
  EXPECT_NEAR(shown.ego.states.back().velocity.x(), 6.0, 1e-9);
  ASSERT_EQ(shown.agents.size(), 1u);
  EXPECT_NEAR(shown.agents[0].states.back().velocity.x(), 4.0, 1e-9);
}

TEST_F(ObservedSceneTest, HoweverOftenItLookedTheFramesAreAnIntervalApart) {
  for (int i = 1; i <= 23; ++i) {
    const double time = kNow + 0.1 * i;
    scene_.add({time, {0.6 * i, 0.0, 0.0}, {seenAt("a", time, {20.0 + 0.4 * i, 0.0, 0.0})}});
  }
  const Snapshot shown = scene_.snapshot();
  EXPECT_NEAR(shown.now, kNow + 2.3, 1e-9);
  ASSERT_EQ(shown.ego.states.size(), 4u);
  for (std::size_t i = 0; i + 1 < shown.ego.states.size(); ++i) {
    EXPECT_NEAR(shown.ego.states[i + 1].time - shown.ego.states[i].time, kInterval, 1e-6);
  }
}

TEST_F(ObservedSceneTest, ClocksThatRoundChangeNothing) {
  constexpr double kEpoch = 1533000000.0;  // s, as nuScenes' clock
  ObservedScene scene({kEpoch, {kEgoId, AgentClass::kCar, kEgoSize, {{kEpoch, {}, {}}}}, {}, {}},
                      {kEgoSize, 0.0}, kFrames, kInterval);
  for (int i = 1; i <= 40; ++i) {
    scene.add({kEpoch + 0.1 * i, {0.6 * i, 0.0, 0.0}, {}});
    if (i < 20) continue;
    const auto states = scene.snapshot().ego.states;
    for (std::size_t j = 0; j + 1 < states.size(); ++j) {
      ASSERT_NEAR(states[j + 1].time - states[j].time, kInterval, 1e-5) << i;
    }
  }
}

TEST_F(ObservedSceneTest, FramesThatJitterAreNotLost) {
  for (const double time : {0.46, 0.97, 1.51, 1.93}) {
    scene_.add({kNow + time, {6.0 * time, 0.0, 0.0}, {}});
  }
  const Snapshot shown = scene_.snapshot();
  ASSERT_EQ(shown.ego.states.size(), 4u);
  EXPECT_NEAR(shown.ego.states.front().time, kNow + 0.46, 1e-9);
}

TEST_F(ObservedSceneTest, WhoIsNotUsableIsLeftOut) {
  Track broken = seenAt("b", kNow + 0.5, {5.0, 0.0, 0.0});
  broken.size.length = 0.0;
  scene_.add({kNow + 0.5, {3.0, 0.0, 0.0}, {broken}});
  EXPECT_EQ(scene_.snapshot().agents.size(), 1u) << "a alone, from before";
}

}  // namespace
}  // namespace forge
