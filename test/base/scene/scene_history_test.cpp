#include "collision_forge/base/scene/scene_history.h"

#include <gtest/gtest.h>

#include <limits>

namespace forge {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
const EgoVehicle kVehicle{{4.084, 1.73}, 1.385};

Track seen(const std::string& id, const Pose2& pose) {
  return {id, AgentClass::kBus, {10.0, 2.9}, {{0.0, pose, Vector2::Zero()}}};
}

Frame frameAt(double time, std::vector<Track> agents = {}) {
  return {time, {4.0 * time, 0.0, 0.1}, std::move(agents)};
}

TEST(SceneHistory, KeepsTheNewestFrames) {
  SceneHistory history(3, kVehicle);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(history.add(frameAt(0.5 * i)), 0);
  const Snapshot snapshot = history.snapshot();
  EXPECT_FALSE(history.empty());
  EXPECT_EQ(snapshot.now, 2.0);
  ASSERT_EQ(snapshot.ego.states.size(), 3u);
  EXPECT_EQ(snapshot.ego.states.front().time, 1.0);
  EXPECT_EQ(snapshot.ego.states.back().pose.x, 8.0);
  EXPECT_EQ(snapshot.ego.states.back().pose.yaw, 0.1);
  EXPECT_NEAR(snapshot.ego.states.back().velocity.x(), 4.0, 1e-12);
}

TEST(SceneHistory, TheEgoHasTheSizeThatWasSet) {
  SceneHistory history(3, kVehicle);
  history.add(frameAt(0.0));
  EXPECT_EQ(history.snapshot().ego.size.length, kVehicle.size.length);
  history.setEgoSize({5.286, 2.332});
  EXPECT_EQ(history.snapshot().ego.size.length, 5.286);
}

TEST(SceneHistory, CollectsTheStatesOfEachAgentSortedById) {
  SceneHistory history(8, kVehicle);
  history.add(frameAt(0.0, {seen("b", {0.0, 0.0, 0.0}), seen("gone", {5.0, 5.0, 0.0})}));
  history.add(frameAt(0.5, {seen("b", {1.0, 0.0, 0.0})}));
  history.add(frameAt(1.0, {seen("b", {2.0, 0.0, 0.0}), seen("a", {7.0, 7.0, 1.0})}));
  const Snapshot snapshot = history.snapshot();
  ASSERT_EQ(snapshot.agents.size(), 3u);
  EXPECT_EQ(snapshot.agents[0].id, "a");
  EXPECT_EQ(snapshot.agents[1].id, "b");
  EXPECT_EQ(snapshot.agents[2].id, "gone");
  const Track& b = snapshot.agents[1];
  EXPECT_EQ(b.agent_class, AgentClass::kBus);
  EXPECT_EQ(b.size.length, 10.0);
  ASSERT_EQ(b.states.size(), 3u);
  EXPECT_EQ(b.states[1].time, 0.5) << "the frame's time counts, not the state's";
  EXPECT_DOUBLE_EQ(b.states[2].velocity.x(), 2.0);
}

TEST(SceneHistory, LeavesOutAndCountsUnusableAgents) {
  Track flat = seen("flat", {});
  flat.size.width = 0.0;
  Track sizeless = seen("sizeless", {});
  sizeless.size.length = kNan;
  Track stateless = seen("stateless", {});
  stateless.states.clear();
  SceneHistory history(4, kVehicle);
  EXPECT_EQ(history.add(frameAt(
                0.0, {flat, seen("good", {}), sizeless, stateless,
                      seen("nowhere", {kNan, 0.0, 0.0}), seen("far", {0.0, kInfinity, 0.0})})),
            5);
  ASSERT_EQ(history.snapshot().agents.size(), 1u);
  EXPECT_EQ(history.snapshot().agents[0].id, "good");
}

TEST(SceneHistory, RefusesAnEgoPoseThatIsNotFinite) {
  SceneHistory history(4, kVehicle);
  Frame frame = frameAt(0.0);
  frame.ego.yaw = kNan;
  EXPECT_THROW(history.add(frame), std::invalid_argument);
  EXPECT_TRUE(history.empty());
}

TEST(SceneHistory, RestartsWhenTimeDoesNotAdvance) {
  SceneHistory history(4, kVehicle);
  history.add(frameAt(0.0, {seen("a", {})}));
  history.add(frameAt(0.5, {seen("a", {})}));
  history.add(frameAt(-10.0));
  const Snapshot snapshot = history.snapshot();
  EXPECT_EQ(snapshot.now, -10.0);
  EXPECT_EQ(snapshot.ego.states.size(), 1u);
  EXPECT_TRUE(snapshot.agents.empty());
}

TEST(SceneHistory, JitteringFramesAreLateAndDoNotRestart) {
  SceneHistory history(4, kVehicle);
  EXPECT_FALSE(history.isLate(0.0));
  history.add(frameAt(5.0));
  EXPECT_FALSE(history.isLate(5.01));
  EXPECT_TRUE(history.isLate(5.0));
  EXPECT_TRUE(history.isLate(4.98));
  EXPECT_TRUE(history.isLate(5.0 - kRestart));
  EXPECT_FALSE(history.isLate(5.0 - 1.01 * kRestart)) << "a replay that starts again";
}

TEST(SceneHistory, SnapshotFramesAreAnIntervalApartAtAnyRate) {
  constexpr double kEpoch = 1533000000.0;  // s, as nuScenes' clock, which rounds
  for (const double rate : {4.0, 10.0, 20.0}) {
    SceneHistory history(4, kVehicle);
    for (int i = 0; i <= 5 * static_cast<int>(rate); ++i) {
      history.add(frameAt(kEpoch + i / rate, {seen("a", {0.0, 0.1 * i, 0.0})}));
    }
    const Snapshot snapshot = history.snapshot();
    EXPECT_NEAR(snapshot.now, kEpoch + 5.0, 1e-6);
    for (const Track& track : {snapshot.ego, snapshot.agents.at(0)}) {
      ASSERT_EQ(track.states.size(), 4u) << rate << " Hz";
      for (std::size_t i = 0; i + 1 < 4; ++i) {
        EXPECT_NEAR(track.states[i + 1].time - track.states[i].time, kFrameInterval, 1e-5) << rate;
      }
    }
  }
}

TEST(SceneHistory, ContinuesFromASnapshotWithItsMap) {
  Snapshot start;
  start.now = 1.0;
  start.map = std::make_shared<const LaneMap>();
  start.ego = {
      kEgoId, AgentClass::kCar, kVehicle.size, {{0.5, {}, {}}, {1.0, {2.0, 0.0, 0.0}, {}}}};
  start.agents = {{"a", AgentClass::kCar, {4.0, 2.0}, {{1.0, {9.0, 0.0, 0.0}, {}}}}};
  SceneHistory history(4, kVehicle, start);
  history.add(frameAt(1.5, {seen("a", {10.0, 0.0, 0.0})}));
  const Snapshot snapshot = history.snapshot();
  EXPECT_EQ(snapshot.map, start.map);
  EXPECT_EQ(history.newest().time, 1.5);
  ASSERT_EQ(snapshot.ego.states.size(), 3u);
  EXPECT_EQ(snapshot.ego.states[1].pose.x, 2.0);
  ASSERT_EQ(snapshot.agents.size(), 1u);
  EXPECT_NEAR(snapshot.agents[0].states.back().velocity.x(), 2.0, 1e-9);
}

TEST(SceneHistory, KeepsOneStateOfAnAgentNamedTwiceInAFrame) {
  SceneHistory history(4, kVehicle);
  history.add(frameAt(0.0, {seen("a", {1.0, 0.0, 0.0}), seen("a", {2.0, 0.0, 0.0})}));
  ASSERT_EQ(history.snapshot().agents.size(), 1u);
  ASSERT_EQ(history.snapshot().agents[0].states.size(), 1u);
  EXPECT_EQ(history.snapshot().agents[0].states[0].pose.x, 1.0);
}

TEST(SceneHistory, EqualsTheSnapshotOfTheSameFramesInAScene) {
  Scene scene;
  scene.ego = {kEgoId, AgentClass::kCar, kVehicle.size, {}};
  Track agent = seen("a", {});
  agent.states.clear();
  SceneHistory history(3, kVehicle);
  for (int i = 0; i < 5; ++i) {
    const double time = 0.5 * i;
    const Pose2 pose{3.0 * time * time, time, 0.2 * time};
    scene.frame_times.push_back(time);
    scene.ego.states.push_back({time, frameAt(time).ego, Vector2::Zero()});
    agent.states.push_back({time, pose, Vector2::Zero()});
    history.add(frameAt(time, {seen("a", pose)}));
  }
  scene.agents = {agent};
  const Snapshot expected = snapshotAt(scene, 2.0, 3);
  const Snapshot snapshot = history.snapshot();
  ASSERT_EQ(snapshot.agents.size(), 1u);
  ASSERT_EQ(snapshot.agents[0].states.size(), 3u);
  ASSERT_EQ(expected.agents[0].states.size(), 3u);
  EXPECT_EQ(snapshot.now, expected.now);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(snapshot.ego.states[i].velocity, expected.ego.states[i].velocity);
    EXPECT_EQ(snapshot.agents[0].states[i].time, expected.agents[0].states[i].time);
    EXPECT_EQ(snapshot.agents[0].states[i].pose.x, expected.agents[0].states[i].pose.x);
    EXPECT_EQ(snapshot.agents[0].states[i].velocity, expected.agents[0].states[i].velocity);
  }
}

TEST(AgentsAt, ReturnsAgentsWithTheirStateAtTheTime) {
  const Track here{
      "here", {}, {4.0, 2.0}, {{1.0, {1.0, 0.0, 0.0}, {}}, {2.0, {2.0, 0.0, 0.0}, {}}}, 1.3};
  const Track gone{"gone", {}, {4.0, 2.0}, {{1.0, {9.0, 0.0, 0.0}, {}}}};
  const std::vector<Track> agents = agentsAt({here, gone}, 2.0 + 5e-7);
  ASSERT_EQ(agents.size(), 1u);
  EXPECT_EQ(agents[0].id, "here");
  EXPECT_EQ(agents[0].height, 1.3);
  ASSERT_EQ(agents[0].states.size(), 1u);
  EXPECT_EQ(agents[0].states[0].pose.x, 2.0);
}

TEST(NewestFrame, HoldsEgoAndAgentsAtT0) {
  Snapshot snapshot;
  snapshot.now = 2.0;
  snapshot.ego.states = {{1.0, {1.0, 0.0, 0.0}, {}}, {2.0, {3.0, 0.0, 0.0}, {}}};
  snapshot.agents = {{"here", {}, {4.0, 2.0}, {{2.0, {2.0, 0.0, 0.0}, {}}}},
                     {"gone", {}, {4.0, 2.0}, {{1.0, {9.0, 0.0, 0.0}, {}}}}};
  const Frame frame = newestFrame(snapshot);
  EXPECT_EQ(frame.time, 2.0);
  EXPECT_EQ(frame.ego.x, 3.0);
  ASSERT_EQ(frame.agents.size(), 1u);
  EXPECT_EQ(frame.agents[0].id, "here");
  snapshot.ego.states.pop_back();
  EXPECT_FALSE(newestFrame(snapshot).ego.isFinite());
}

}  // namespace
}  // namespace forge
