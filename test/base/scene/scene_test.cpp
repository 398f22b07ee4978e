#include "collision_forge/base/scene/scene.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

/// Along +x at 4 m/s, x = 4 * time, one state each `interval`; recorded velocities are nonsense.
Track drive(const std::string& id, double first, double last, double interval) {
  Track track{id, AgentClass::kTruck, {6.0, 2.5}, {}};
  for (int i = 0; first + i * interval <= last + 1e-9; ++i) {
    const double time = first + i * interval;
    track.states.push_back({time, {4.0 * time, 0.0, 0.0}, Vector2(99.0, 99.0)});
  }
  return track;
}

/// Ten frames at 2 Hz from 100 s on; the ego has poses at 20 Hz.
Scene tenFrames() {
  Scene scene;
  scene.ego = drive(kEgoId, 100.0, 104.5, 0.05);
  for (int i = 0; i < 10; ++i) scene.frame_times.push_back(100.0 + 0.5 * i);
  scene.agents = {drive("always", 100.0, 104.5, 0.5), drive("early", 100.0, 101.0, 0.5),
                  drive("late", 103.0, 104.5, 0.5)};
  auto map = std::make_shared<LaneMap>();
  map->location = "somewhere";
  scene.map = map;
  return scene;
}

TEST(LastFrameTime, IsTheNewestFrameUpToThen) {
  const Scene scene = tenFrames();
  EXPECT_FALSE(lastFrameTime(scene, 99.9));
  EXPECT_EQ(lastFrameTime(scene, 100.0), 100.0);
  EXPECT_EQ(lastFrameTime(scene, 102.4), 102.0);
  EXPECT_EQ(lastFrameTime(scene, 102.5 - 5e-7), 102.5) << "rounding is absorbed";
  EXPECT_EQ(lastFrameTime(scene, 1e9), 104.5);
  EXPECT_FALSE(lastFrameTime(Scene{}, 0.0));
}

TEST(SnapshotAt, HoldsTheNewestFramesAndNothingLater) {
  const Snapshot snapshot = snapshotAt(tenFrames(), 102.5, 4);
  EXPECT_EQ(snapshot.now, 102.5);
  EXPECT_EQ(snapshot.map->location, "somewhere");
  ASSERT_EQ(snapshot.ego.states.size(), 4u);
  EXPECT_EQ(snapshot.ego.states.front().time, 101.0);
  EXPECT_EQ(snapshot.ego.states.back().time, 102.5);
  EXPECT_DOUBLE_EQ(snapshot.ego.states.back().pose.x, 410.0);
  ASSERT_EQ(snapshot.agents.size(), 2u);
  EXPECT_EQ(snapshot.agents[0].id, "always");
  EXPECT_EQ(snapshot.agents[0].states.size(), 4u);
  EXPECT_EQ(snapshot.agents[0].states.back().time, 102.5);
  EXPECT_EQ(snapshot.agents[1].id, "early") << "seen in the oldest of the frames";
  EXPECT_EQ(snapshot.agents[1].states.size(), 1u);
  EXPECT_EQ(snapshot.agents[1].agent_class, AgentClass::kTruck);
  EXPECT_EQ(snapshot.agents[1].size.length, 6.0);
}

TEST(HistoryTimes, AreAnIntervalApartAtAnyFrameRate) {
  using Times = std::vector<double>;
  EXPECT_EQ(historyTimes({}, 3), Times());
  EXPECT_EQ(historyTimes({1.0, 1.5, 2.0, 2.5}, 3), (Times{1.5, 2.0, 2.5}));
  EXPECT_EQ(historyTimes({1.0, 1.25, 1.5, 1.75, 2.0, 2.25, 2.5}, 3), (Times{1.5, 2.0, 2.5}));
  EXPECT_EQ(historyTimes({1.04, 1.46, 2.03, 2.5}, 8), (Times{1.04, 1.46, 2.03, 2.5})) << "jitter";
  EXPECT_EQ(historyTimes({1.0, 2.0, 4.0}, 8), (Times{1.0, 2.0, 4.0})) << "rare frames";
  EXPECT_EQ(historyTimes({2.3, 2.4, 2.5}, 8), (Times{2.3, 2.5})) << "too short for a second one";
}

TEST(SnapshotAt, DerivesVelocitiesFromThePastAlone) {
  Scene scene = tenFrames();
  for (AgentState& state : scene.ego.states) {
    if (state.time > 102.5) state.pose.x = 1e6;
  }
  for (Track& agent : scene.agents) {
    for (AgentState& state : agent.states) {
      if (state.time > 102.5) state.pose.x = 1e6;
    }
  }
  const Snapshot snapshot = snapshotAt(scene, 102.5, 8);
  for (const AgentState& state : snapshot.ego.states) EXPECT_NEAR(state.velocity.x(), 4.0, 1e-9);
  for (const AgentState& state : snapshot.agents[0].states) {
    EXPECT_NEAR(state.velocity.x(), 4.0, 1e-9);
    EXPECT_NEAR(state.velocity.y(), 0.0, 1e-9);
  }
}

TEST(RecordedFuture, RunsFromNowToTheEgosEnd) {
  Scene scene = tenFrames();
  scene.agents[0] = drive("always", 100.0, 110.0, 0.5);
  const Future future = recordedFuture(scene, 102.5);
  EXPECT_NEAR(future.ego.states.front().time, 102.5, 1e-9);
  EXPECT_NEAR(future.ego.states.back().time, 104.5, 1e-9);
  EXPECT_EQ(future.ego.states.size(), 41u);
  ASSERT_EQ(future.agents.size(), 2u);
  EXPECT_EQ(future.agents[0].id, "always");
  EXPECT_EQ(future.agents[0].states.front().time, 102.5);
  EXPECT_EQ(future.agents[0].states.back().time, 104.5);
  EXPECT_EQ(future.agents[1].id, "late");
  EXPECT_EQ(future.agents[1].states.front().time, 103.0);
}

}  // namespace
}  // namespace forge
