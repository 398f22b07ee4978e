#include "collision_forge/base/scene/support_vehicles.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

constexpr double kNow = 100.0;  // s
constexpr BoxSize kCarSize{4.6, 1.9};

/// Returns a car that drives straight on through `now` at kNow, with a state every 0.5 s.
Track straightTrack(const std::string& id, const Pose2& now, double first, double last) {
  constexpr double kSpeed = 10.0;  // m/s
  Track track{id, AgentClass::kCar, kCarSize, {}};
  for (double time = first; time <= last; time += 0.5) {
    track.states.push_back({time, compose(now, {kSpeed * (time - kNow), 0.0, 0.0}), {kSpeed, 0.0}});
  }
  return track;
}

Scene recordedScene() {
  Scene scene;
  scene.ego = straightTrack("ego", {}, kNow - 3.5, kNow + 10.0);
  return scene;
}

SupportVehicle parkedCar() {
  SupportVehicle support;
  support.motion = {"parked-1", AgentClass::kCar, kCarSize, {}};
  for (double time = 0.0; time <= 4.0; time += 1.0) {
    support.motion.points.push_back({kNow + time, {20.0, -3.0, 0.0}});
  }
  for (const double before : {3.5, 2.0, 0.0}) {
    support.motion.past.push_back({kNow - before, {20.0, -3.0, 0.0}, Vector2::Zero()});
  }
  return support;
}

TEST(SupportVehicles, AParkedOneStandsToTheEndOfAScene) {
  Scene scene = recordedScene();
  addSupports({parkedCar()}, scene);
  ASSERT_EQ(scene.agents.size(), 1U);
  const Track& parked = scene.agents.front();
  for (double time = kNow - 3.5; time <= kNow + 10.0; time += 0.25) {
    const auto state = stateAt(parked, time, 4.0);
    ASSERT_TRUE(state) << time - kNow;
    EXPECT_EQ(state->pose.x, 20.0);
  }
  EXPECT_NEAR(parked.states.back().time, kNow + 10.0, 1e-9);
  for (std::size_t i = 1; i < parked.states.size(); ++i) {
    EXPECT_GT(parked.states[i].time, parked.states[i - 1].time);
  }
}

TEST(SupportVehicles, JoinTheFramesOfASnapshot) {
  Snapshot snapshot;
  snapshot.now = kNow;
  snapshot.ego = straightTrack("ego", {}, kNow - 3.5, kNow);
  addSupports({parkedCar()}, snapshot);
  ASSERT_EQ(snapshot.agents.size(), 1U);
  EXPECT_TRUE(endsAt(snapshot.agents.front(), kNow));
}

TEST(SupportVehicles, JoinAFutureFromT0On) {
  Future future;
  future.ego = straightTrack("ego", {}, kNow, kNow + 10.0);
  addSupports({parkedCar()}, future);
  ASSERT_EQ(future.agents.size(), 1U);
  EXPECT_NEAR(future.agents.front().states.front().time, kNow, 1e-9);
  EXPECT_NEAR(future.agents.front().states.back().time, kNow + 10.0, 1e-9);
}

TEST(SupportVehicles, AMovingOneThatEndedBeforeAFutureBeginsIsNotAdded) {
  SupportVehicle leader = parkedCar();
  for (TrajectoryPoint& point : leader.motion.points) point.speed = 5.0;
  Future future;
  future.ego = straightTrack("ego", {}, kNow + 6.0, kNow + 10.0);
  addSupports({leader}, future);
  EXPECT_TRUE(future.agents.empty());
}

TEST(SupportVehicles, ReplaceTheAgentOfTheirIdFromT0On) {
  Scene scene = recordedScene();
  scene.agents = {straightTrack("leader", {20.0, 0.0, 0.0}, kNow - 3.5, kNow + 10.0)};
  SupportVehicle leader{SupportRole::kLeader, {"leader", AgentClass::kCar, kCarSize, {}}};
  for (double time = 0.0; time <= 3.0; time += 0.5) {
    leader.motion.points.push_back({kNow + time, {20.0 + 10.0 * time, time, 0.1}, 10.0});
  }
  addSupports({leader}, scene);
  ASSERT_EQ(scene.agents.size(), 1U);
  const Track& track = scene.agents.front();
  EXPECT_EQ(stateAt(track, kNow - 1.0)->pose.y, 0.0) << "as recorded before t0";
  EXPECT_GT(stateAt(track, kNow + 2.0)->pose.y, 1.0);
  EXPECT_NEAR(track.states.back().time, kNow + 3.0, 1e-9) << "unknown after its last point";
}

}  // namespace
}  // namespace forge
