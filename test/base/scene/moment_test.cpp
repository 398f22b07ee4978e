#include "collision_forge/base/scene/moment.h"

#include <gtest/gtest.h>

#include <string>

namespace forge {
namespace {

/// Ego and one agent drive 5 m/s along x; frames at 2 Hz from 0 to 10 s.
IndexedScene recording() {
  Scene scene;
  scene.ego = {kEgoId, AgentClass::kCar, {4.0, 1.7}, {}};
  scene.agents = {{"agent", AgentClass::kCar, {4.5, 1.9}, {}}};
  for (int i = 0; i <= 20; ++i) {
    const double time = 0.5 * i;
    scene.frame_times.push_back(time);
    scene.ego.states.push_back({time, {5.0 * time, 0.0, 0.0}, {5.0, 0.0}});
    scene.agents[0].states.push_back({time, {5.0 * time, 3.5, 0.0}, {5.0, 0.0}});
  }
  scene.map = std::make_shared<const LaneMap>();
  return {scene, std::make_shared<const LaneIndex>(scene.map)};
}

TEST(Moment, HoldsSnapshotAndRecordedFuture) {
  const IndexedScene indexed = recording();
  const auto found = momentAt(indexed, 4.0 + 5e-7, 4);
  const Moment& moment = std::get<Moment>(found);
  EXPECT_EQ(moment.snapshot.now, 4.0);
  ASSERT_EQ(moment.snapshot.ego.states.size(), 4u);
  EXPECT_EQ(moment.snapshot.ego.states.back().time, 4.0);
  ASSERT_TRUE(moment.recorded);
  EXPECT_EQ(moment.recorded->ego.states.front().time, 4.0);
  EXPECT_EQ(moment.recorded->ego.states.back().time, 10.0);
  EXPECT_EQ(moment.lanes, indexed.lanes);
  ASSERT_TRUE(moment.past);
  EXPECT_EQ(moment.past->now, 4.0);
  ASSERT_EQ(moment.past->ego.states.size(), 9u) << "from the first frame on";
  EXPECT_EQ(moment.past->agents.front().states.front().time, 0.0);
  EXPECT_EQ(moment.past->agents.front().states.back().time, 4.0);
}

TEST(Moment, RejectsATimeWithoutFrameNamingTheNearest) {
  for (const double now : {4.1, 3.9}) {
    const auto found = momentAt(recording(), now, 4);
    const Status& status = std::get<Status>(found);
    EXPECT_EQ(status.code, StatusCode::kNoScene);
    EXPECT_NE(status.message.find("4.000000"), std::string::npos) << status.message;
  }
}

}  // namespace
}  // namespace forge
