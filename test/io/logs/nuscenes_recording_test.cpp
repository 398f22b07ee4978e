#include "collision_forge/io/logs/nuscenes_recording.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "collision_forge/io/logs/nuscenes_tables.h"
#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

using ::testing::ElementsAre;

/// One instance, at (x, 2x, 0) at each time in seconds.
NuScenesRecording track(const std::vector<std::pair<double, double>>& times_and_x) {
  NuScenesRecording recording;
  for (const auto& [time, x] : times_and_x) {
    NuScenesAnnotation annotation;
    annotation.instance = "one";
    annotation.translation = {x, 2.0 * x, 0.0};
    annotation.size = {4.0, 2.0, 1.5};
    recording.frames.push_back({"", std::llround(time * 1e6), {annotation}});
  }
  return recording;
}

std::vector<double> velocitiesOf(const std::vector<std::pair<double, double>>& times_and_x) {
  NuScenesRecording recording = track(times_and_x);
  deriveVelocities(recording);
  std::vector<double> velocities;
  for (const NuScenesFrame& frame : recording.frames) {
    const Eigen::Vector3d& velocity = frame.annotations.at(0).velocity;
    EXPECT_DOUBLE_EQ(velocity.y(), 2.0 * velocity.x());
    velocities.push_back(velocity.x());
  }
  return velocities;
}

TEST(NuScenesRecording, velocitiesAreCentralAndOneSidedAtTheEnds) {
  EXPECT_THAT(velocitiesOf({{0.0, 0.0}, {0.5, 5.0}, {1.0, 12.0}}), ElementsAre(10.0, 12.0, 14.0));
  EXPECT_THAT(velocitiesOf({{3.0, 7.0}}), ElementsAre(0.0));
}

TEST(NuScenesRecording, velocitiesBesideGaps) {
  EXPECT_THAT(velocitiesOf({{0.0, 0.0}, {1.5, 3.0}}), ElementsAre(2.0, 2.0));
  EXPECT_THAT(velocitiesOf({{0.0, 0.0}, {1.6, 3.0}}), ElementsAre(0.0, 0.0));
  EXPECT_THAT(velocitiesOf({{0.0, 0.0}, {2.0, 1.0}, {3.0, 6.0}}), ElementsAre(0.0, 2.0, 5.0))
      << "both sides: up to 3 s, as the devkit has it";
  EXPECT_THAT(velocitiesOf({{0.0, 0.0}, {1.0, 1.0}, {4.0, 6.0}}), ElementsAre(1.0, 1.0, 0.0))
      << "more than 3 s: the nearer side";
}

TEST(NuScenesRecording, onlyAFinitePositiveHeightIsKnown) {
  NuScenesRecording recording = track({{0.0, 0.0}});
  const auto heightOfZ = [&](double z) {
    recording.frames.at(0).annotations.at(0).size.z() = z;
    return toScene(recording, {{4.084, 1.73}, 1.5}, nullptr).agents.at(0).height;
  };
  EXPECT_EQ(heightOfZ(1.5), 1.5);
  for (const double unknown : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    EXPECT_EQ(heightOfZ(unknown), std::nullopt) << unknown;
  }
}

TEST(NuScenesRecording, sceneOfTheTinyTables) {
  const TemporaryFolder folder;
  writeTables(folder, tinyTables());
  const NuScenesRecording recording =
      NuScenesRoot(folder.path(), "v1.0-tiny").readScene("scene-0001");
  for (const DrivingSide side : {DrivingSide::kLeft, DrivingSide::kRight}) {
    LaneMap lane_map;
    lane_map.driving_side = side;
    const auto map = std::make_shared<const LaneMap>(lane_map);
    const Scene scene = toScene(recording, {{4.084, 1.73}, 1.5}, map);
    EXPECT_EQ(scene.name, "scene-0001");
    EXPECT_EQ(scene.map, map);
    EXPECT_THAT(scene.frame_times, ElementsAre(1533000000000001 * 1e-6, 1533000000500000 * 1e-6,
                                               1533000001000000 * 1e-6));
    EXPECT_EQ(scene.ego.id, kEgoId);
    EXPECT_EQ(scene.ego.size.length, 4.084);
    ASSERT_EQ(scene.ego.states.size(), 3U);
    EXPECT_NEAR(scene.ego.states[0].pose.x, 100.0, 1e-9);
    EXPECT_NEAR(scene.ego.states[0].pose.y, 201.5, 1e-9) << "1.5 m ahead, heading along +y";
    EXPECT_NEAR(scene.ego.states[0].pose.yaw, std::acos(0.0), 1e-12);
    EXPECT_NEAR(scene.ego.states[1].velocity.y(), 8.0, 1e-6);
    ASSERT_EQ(scene.agents.size(), 2U);
    const Track& car = scene.agents[0];
    EXPECT_EQ(car.id, kHexToken);
    EXPECT_EQ(car.agent_class, AgentClass::kCar);
    EXPECT_EQ(car.size.length, 4.5);
    EXPECT_EQ(car.size.width, 2.0);
    ASSERT_EQ(car.states.size(), 3U);
    EXPECT_NEAR(car.states[0].velocity.x(), 5.0 / 0.499999, 1e-9);
    EXPECT_NEAR(car.states[1].velocity.x(), 12.0 / 0.999999, 1e-9);
    EXPECT_NEAR(car.states[2].velocity.x(), 14.0, 1e-9);
    EXPECT_EQ(car.states[1].pose.x, 15.0);
    const Track& pedestrian = scene.agents[1];
    EXPECT_EQ(pedestrian.agent_class, AgentClass::kPedestrian);
    ASSERT_EQ(pedestrian.states.size(), 1U);
    EXPECT_NEAR(std::abs(pedestrian.states[0].pose.yaw), 2.0 * std::acos(0.0), 1e-12);
    EXPECT_EQ(pedestrian.states[0].velocity, Vector2(0.0, 0.0));
  }
}

TEST(NuScenesRecording, yawOfATiltedRotation) {
  const Eigen::Quaterniond rotation = Eigen::AngleAxisd(-2.0, Eigen::Vector3d::UnitZ()) *
                                      Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitY()) *
                                      Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitX());
  EXPECT_NEAR(yawOf(rotation), -2.0, 1e-12);
}

TEST(NuScenesRecording, everyCategoryHasItsClass) {
  const std::pair<const char*, AgentClass> expected[] = {
      {"vehicle.car", AgentClass::kCar},
      {"vehicle.truck", AgentClass::kTruck},
      {"vehicle.bus.bendy", AgentClass::kBus},
      {"vehicle.bus.rigid", AgentClass::kBus},
      {"vehicle.trailer", AgentClass::kTrailer},
      {"vehicle.construction", AgentClass::kConstructionVehicle},
      {"vehicle.emergency.ambulance", AgentClass::kEmergencyVehicle},
      {"vehicle.motorcycle", AgentClass::kMotorcycle},
      {"vehicle.bicycle", AgentClass::kBicycle},
      {"human.pedestrian.stroller", AgentClass::kPedestrian},
      {"human.pedestrian.adult", AgentClass::kPedestrian},
      {"human.pedestrian.child", AgentClass::kChild},
      {"human.pedestrian.personal_mobility", AgentClass::kScooter},
      {"animal", AgentClass::kAnimal},
      {"movable_object.trafficcone", AgentClass::kStaticObject},
      {"static_object.bicycle_rack", AgentClass::kStaticObject}};
  for (const auto& [category, agent_class] : expected) {
    EXPECT_EQ(agentClassOfCategory(category), agent_class) << category;
  }
  for (const char* category : {"vehicle", "vehicle.cart", "", "car"}) {
    EXPECT_FALSE(agentClassOfCategory(category).has_value()) << category;
  }
}

TEST(NuScenesRecording, otherCategoriesAreTheLongestNamesOfTheConfiguration) {
  const std::map<std::string, AgentClass> others = {{"pedestrian", AgentClass::kPedestrian},
                                                    {"vehicle", AgentClass::kCar},
                                                    {"vehicle.fire", AgentClass::kTruck}};
  const auto classOf = [&](const char* category) { return agentClassOfCategory(category, others); };
  EXPECT_EQ(classOf("Pedestrian.Adult"), AgentClass::kPedestrian);
  EXPECT_EQ(classOf("vehicle.fire.engine"), AgentClass::kTruck);
  EXPECT_EQ(classOf("vehicle.cart"), AgentClass::kCar);
  EXPECT_EQ(classOf("vehicle.bus.rigid"), AgentClass::kBus);
  EXPECT_EQ(classOf("pedestrians"), std::nullopt);
}

TEST(NuScenesRecording, anUnknownCategoryIsAStaticObject) {
  NuScenesRecording recording = track({{0.0, 0.0}, {0.5, 1.0}});
  for (NuScenesFrame& frame : recording.frames) frame.annotations[0].category = "vehicle.ufo";
  const Scene scene = toScene(recording, {}, nullptr);
  EXPECT_EQ(scene.agents.at(0).agent_class, AgentClass::kStaticObject);
}

}  // namespace
}  // namespace forge
