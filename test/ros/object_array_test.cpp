#include "collision_forge/ros/messages/object_array.h"

#include <gtest/gtest.h>

#include "collision_forge/ros/messages/ros_bytes.h"
#include "ros/ros_decoder.h"

namespace forge {
namespace {

using collision_forge::Agent;

collision_forge::AgentArray agentsOf(const std::vector<std::uint8_t>& classes) {
  collision_forge::AgentArray agents;
  agents.header.frame_id = "map";
  agents.header.stamp = ros::Time(12, 500000000);
  for (const std::uint8_t agent_class : classes) {
    Agent agent;
    agent.id = std::to_string(70 + agents.agents.size());
    agent.agent_class = agent_class;
    agent.size.x = 4.5;
    agent.size.y = 1.8;
    agent.size.z = 1.5;
    agent.pose.position.x = 10.0;
    agent.pose.orientation.w = 1.0;
    agent.velocity.y = -3.0;
    agents.agents.push_back(agent);
  }
  return agents;
}

RosDecoder decoded(const collision_forge::AgentArray& agents) {
  std::string bytes;
  appendRosBytes(bytes, toObjects(agents));
  return {kObjectArrayDefinition, bytes};
}

TEST(ObjectArray, EveryAgentIsATrackedBox) {
  const RosDecoder message = decoded(agentsOf({Agent::CAR, Agent::PEDESTRIAN}));
  EXPECT_EQ(message.number("header.stamp"), 12.5);
  ASSERT_EQ(message.size("objects"), 2U);
  for (const std::string object : {"objects[0]", "objects[1]"}) {
    EXPECT_EQ(message.number(object + ".header.stamp"), 12.5);
    EXPECT_EQ(message.text(object + ".header.frame_id"), "map");
    EXPECT_EQ(message.number(object + ".detection_level"), 1.0) << "OBJECT_TRACKED";
    EXPECT_EQ(message.number(object + ".pose.position.x"), 10.0);
    EXPECT_EQ(message.number(object + ".pose.orientation.w"), 1.0);
    EXPECT_EQ(message.number(object + ".twist.linear.y"), -3.0);
    EXPECT_EQ(message.number(object + ".shape.type"), 1.0) << "BOX";
    ASSERT_EQ(message.size(object + ".shape.dimensions"), 3U);
    EXPECT_EQ(message.number(object + ".shape.dimensions[0]"), 4.5);
    EXPECT_EQ(message.number(object + ".shape.dimensions[1]"), 1.8);
    EXPECT_EQ(message.number(object + ".shape.dimensions[2]"), 1.5);
  }
  EXPECT_EQ(message.number("objects[0].id"), 70.0);
  EXPECT_EQ(message.number("objects[1].id"), 71.0);
}

TEST(ObjectArray, ClassesAreMappedToTheConstantsOfTheMessage) {
  const std::pair<std::uint8_t, int> classes[] = {
      {Agent::CAR, 6},        {Agent::TRUCK, 7},         {Agent::BUS, 9},
      {Agent::TRAILER, 9},    {Agent::BICYCLE, 5},       {Agent::CONSTRUCTION_VEHICLE, 9},
      {Agent::MOTORCYCLE, 8}, {Agent::ANIMAL, 0},        {Agent::EMERGENCY_VEHICLE, 9},
      {Agent::PEDESTRIAN, 4}, {Agent::STATIC_OBJECT, 0}, {Agent::CHILD, 4},
      {Agent::RUNNER, 4},     {Agent::SCOOTER, 5}};
  for (const auto& [agent_class, classification] : classes) {
    const RosDecoder message = decoded(agentsOf({agent_class}));
    const bool is_known = classification != 0;
    EXPECT_EQ(message.number("objects[0].classification"), classification) << int{agent_class};
    EXPECT_EQ(message.number("objects[0].object_classified"), is_known ? 1.0 : 0.0);
    EXPECT_EQ(message.number("objects[0].classification_certainty"), is_known ? 255.0 : 0.0);
  }
}

/// Values of Python's zlib.crc32().
TEST(ObjectArray, ANonNumericIdBecomesItsChecksum) {
  EXPECT_EQ(objectId("added-14"), 2803229739U);
  EXPECT_EQ(objectId("4294967296"), 3267533297U);
  EXPECT_EQ(objectId("-1"), 808273962U);
  EXPECT_EQ(objectId(""), 0U);
}

}  // namespace
}  // namespace forge
