#include "collision_forge/ros/messages/object_array.h"

#include <collision_forge/Agent.h>
#include <zlib.h>

#include <charconv>

namespace forge {
namespace {

using collision_forge::Agent;

// Constants of derived_object_msgs/Object.
constexpr std::uint8_t kUnknown = 0;
constexpr std::uint8_t kPedestrian = 4;
constexpr std::uint8_t kBike = 5;
constexpr std::uint8_t kCar = 6;
constexpr std::uint8_t kTruck = 7;
constexpr std::uint8_t kMotorcycle = 8;
constexpr std::uint8_t kOtherVehicle = 9;

std::uint8_t classificationOf(std::uint8_t agent_class) {
  switch (agent_class) {
    case Agent::CAR:
      return kCar;
    case Agent::TRUCK:
      return kTruck;
    case Agent::BUS:
    case Agent::TRAILER:
    case Agent::CONSTRUCTION_VEHICLE:
    case Agent::EMERGENCY_VEHICLE:
      return kOtherVehicle;
    case Agent::MOTORCYCLE:
      return kMotorcycle;
    case Agent::BICYCLE:
    case Agent::SCOOTER:
      return kBike;
    case Agent::PEDESTRIAN:
    case Agent::CHILD:
    case Agent::RUNNER:
      return kPedestrian;
    default:
      return kUnknown;
  }
}

}  // namespace

std::uint32_t objectId(const std::string& agent_id) {
  std::uint32_t number = 0;
  const char* const end = agent_id.data() + agent_id.size();
  const auto [rest, error] = std::from_chars(agent_id.data(), end, number);
  if (error == std::errc() && rest == end) return number;
  const auto* const bytes = reinterpret_cast<const Bytef*>(agent_id.data());
  return static_cast<std::uint32_t>(crc32(0, bytes, static_cast<uInt>(agent_id.size())));
}

ObjectArray toObjects(const collision_forge::AgentArray& agents) {
  ObjectArray message;
  message.header = agents.header;
  for (const Agent& agent : agents.agents) {
    message.objects.push_back({objectId(agent.id), agent.pose, agent.velocity, agent.size,
                               classificationOf(agent.agent_class)});
  }
  return message;
}

}  // namespace forge
