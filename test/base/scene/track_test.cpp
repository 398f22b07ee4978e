#include "collision_forge/base/scene/track.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace forge {
namespace {

Track trackOf(const std::vector<std::pair<double, Pose2>>& poses) {
  Track track{"a", AgentClass::kCar, {4.0, 2.0}, {}};
  for (const auto& [time, pose] : poses) track.states.push_back({time, pose, Vector2::Zero()});
  return track;
}

TEST(CanAttack, HoldsForMotorVehiclesCyclesAndPeopleOnFoot) {
  std::vector<std::string> attackers;
  std::vector<std::string> motor_vehicles;
  for (int i = 0; i <= static_cast<int>(kLastAgentClass); ++i) {
    const auto agent_class = static_cast<AgentClass>(i);
    if (canAttack(agent_class)) attackers.push_back(toString(agent_class));
    if (isMotorVehicle(agent_class)) motor_vehicles.push_back(toString(agent_class));
  }
  EXPECT_THAT(motor_vehicles,
              testing::UnorderedElementsAre("car", "truck", "bus", "construction_vehicle",
                                            "emergency_vehicle", "motorcycle"));
  motor_vehicles.insert(motor_vehicles.end(),
                        {"bicycle", "scooter", "pedestrian", "child", "runner"});
  EXPECT_THAT(attackers, testing::UnorderedElementsAreArray(motor_vehicles));
}

TEST(IsVehicle, HoldsForAllButPeopleAnimalsAndThings) {
  std::vector<std::string> others;
  for (int i = 0; i <= static_cast<int>(kLastAgentClass); ++i) {
    const auto agent_class = static_cast<AgentClass>(i);
    if (!isVehicle(agent_class)) others.push_back(toString(agent_class));
  }
  EXPECT_THAT(others, testing::UnorderedElementsAre("pedestrian", "child", "runner", "animal",
                                                    "static_object"));
}

TEST(TypicalHeight, OrdersTheClassesByHeight) {
  const std::vector<std::pair<AgentClass, double>> by_height = {
      {AgentClass::kAnimal, 0.6},
      {AgentClass::kStaticObject, 1.0},
      {AgentClass::kChild, 0.5},
      {AgentClass::kCar, 4.5},
      {AgentClass::kMotorcycle, 2.1},
      {AgentClass::kPedestrian, 0.7},
      {AgentClass::kBicycle, 1.8},
      {AgentClass::kScooter, 1.3},
      {AgentClass::kTruck, 5.7},
      {AgentClass::kTruck, 8.0},
      {AgentClass::kConstructionVehicle, 6.4},
      {AgentClass::kBus, 11.0},
      {AgentClass::kTrailer, 12.0}};
  const auto height = [](const std::pair<AgentClass, double>& one) {
    return typicalHeight(one.first, {one.second, 1.0});
  };
  for (std::size_t i = 1; i < by_height.size(); ++i) {
    EXPECT_LT(height(by_height[i - 1]), height(by_height[i])) << toString(by_height[i].first);
  }
  EXPECT_EQ(height({AgentClass::kRunner, 0.7}), height({AgentClass::kPedestrian, 0.7}));
  EXPECT_EQ(height({AgentClass::kEmergencyVehicle, 6.5}), height({AgentClass::kTruck, 5.7}));
}

TEST(StateAt, InterpolatesPoseAndVelocity) {
  Track track = trackOf({{1.0, {0.0, 0.0, 0.0}}, {1.5, {4.0, 2.0, 0.4}}});
  track.states[0].velocity = {8.0, 4.0};
  track.states[1].velocity = {12.0, 0.0};
  const auto state = stateAt(track, 1.125);
  ASSERT_TRUE(state);
  EXPECT_EQ(state->time, 1.125);
  EXPECT_DOUBLE_EQ(state->pose.x, 1.0);
  EXPECT_DOUBLE_EQ(state->pose.y, 0.5);
  EXPECT_DOUBLE_EQ(state->pose.yaw, 0.1);
  EXPECT_DOUBLE_EQ(state->velocity.x(), 9.0);
  EXPECT_DOUBLE_EQ(state->velocity.y(), 3.0);
}

TEST(StateAt, IsEmptyOutsideTheTrack) {
  const Track track = trackOf({{1.0, {}}, {1.5, {}}});
  EXPECT_FALSE(stateAt(track, 0.999));
  EXPECT_TRUE(stateAt(track, 1.0));
  EXPECT_TRUE(stateAt(track, 1.5));
  EXPECT_FALSE(stateAt(track, 1.501));
  EXPECT_FALSE(stateAt(Track{}, 0.0));
}

TEST(StateAt, IsEmptyWithinALongGapButNotAtItsEnds) {
  const Track track = trackOf({{0.0, {}}, {1.5, {}}, {2.5, {}}});
  EXPECT_TRUE(stateAt(track, 0.0));
  EXPECT_FALSE(stateAt(track, 0.01));
  EXPECT_FALSE(stateAt(track, 1.49));
  EXPECT_TRUE(stateAt(track, 1.5));
  EXPECT_TRUE(stateAt(track, 2.0));
  EXPECT_TRUE(stateAt(track, 0.75, 1.5)) << "a gap as long as max_gap is none";
  EXPECT_FALSE(stateAt(track, 0.75, 1.49));
}

TEST(NewestAt, HoldsToAMicrosecond) {
  const Track track = trackOf({{1.0, {}}, {1.5, {}}});
  EXPECT_TRUE(endsAt(track, 1.5));
  EXPECT_TRUE(endsAt(track, 1.5 + 5e-7));
  EXPECT_TRUE(endsAt(track, 1.5 - 5e-7));
  EXPECT_FALSE(endsAt(track, 1.5 + 2e-6));
  EXPECT_FALSE(endsAt(track, 1.0));
  EXPECT_FALSE(endsAt(Track{}, 0.0));
}

TEST(DeriveVelocities, UsesCentralDifferencesAndOneSidedOnesAtTheEnds) {
  Track track = trackOf({{0.0, {0.0, 0.0, 0.0}}, {0.5, {1.0, 0.0, 0.0}}, {1.0, {4.0, 2.0, 0.0}}});
  deriveVelocities(track);
  EXPECT_DOUBLE_EQ(track.states[0].velocity.x(), 2.0);
  EXPECT_DOUBLE_EQ(track.states[1].velocity.x(), 4.0);
  EXPECT_DOUBLE_EQ(track.states[1].velocity.y(), 2.0);
  EXPECT_DOUBLE_EQ(track.states[2].velocity.x(), 6.0);
  EXPECT_DOUBLE_EQ(track.states[2].velocity.y(), 4.0);
}

TEST(DeriveVelocities, DoesNotLookAcrossLongGaps) {
  Track track = trackOf({{0.0, {0.0, 0.0, 0.0}},
                         {0.5, {1.0, 0.0, 0.0}},
                         {2.5, {50.0, 0.0, 0.0}},
                         {3.0, {52.0, 0.0, 0.0}}});
  deriveVelocities(track);
  EXPECT_DOUBLE_EQ(track.states[1].velocity.x(), 2.0);
  EXPECT_DOUBLE_EQ(track.states[2].velocity.x(), 4.0);
}

}  // namespace
}  // namespace forge
