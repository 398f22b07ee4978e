#include "collision_forge/ros/object_array.h"

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
      return kBike;
    case Agent::PEDESTRIAN:
      return kPedestrian;
    default:
      return kUnknown;
  }
}

}  // namespace

const char kObjectArrayDefinition[] = R"(std_msgs/Header header
derived_object_msgs/Object[] objects
================================================================================
MSG: std_msgs/Header
uint32 seq
time stamp
string frame_id
================================================================================
MSG: derived_object_msgs/Object
std_msgs/Header header
uint32 id
uint8 detection_level
uint8 OBJECT_DETECTED=0
uint8 OBJECT_TRACKED=1
bool object_classified
geometry_msgs/Pose pose
geometry_msgs/Twist twist
geometry_msgs/Accel accel
geometry_msgs/Polygon polygon
shape_msgs/SolidPrimitive shape
uint8 classification
uint8 CLASSIFICATION_UNKNOWN=0
uint8 CLASSIFICATION_UNKNOWN_SMALL=1
uint8 CLASSIFICATION_UNKNOWN_MEDIUM=2
uint8 CLASSIFICATION_UNKNOWN_BIG=3
uint8 CLASSIFICATION_PEDESTRIAN=4
uint8 CLASSIFICATION_BIKE=5
uint8 CLASSIFICATION_CAR=6
uint8 CLASSIFICATION_TRUCK=7
uint8 CLASSIFICATION_MOTORCYCLE=8
uint8 CLASSIFICATION_OTHER_VEHICLE=9
uint8 CLASSIFICATION_BARRIER=10
uint8 CLASSIFICATION_SIGN=11
uint8 classification_certainty
uint32 classification_age
================================================================================
MSG: geometry_msgs/Pose
Point position
Quaternion orientation
================================================================================
MSG: geometry_msgs/Point
float64 x
float64 y
float64 z
================================================================================
MSG: geometry_msgs/Quaternion
float64 x
float64 y
float64 z
float64 w
================================================================================
MSG: geometry_msgs/Twist
Vector3 linear
Vector3 angular
================================================================================
MSG: geometry_msgs/Vector3
float64 x
float64 y
float64 z
================================================================================
MSG: geometry_msgs/Accel
Vector3 linear
Vector3 angular
================================================================================
MSG: geometry_msgs/Polygon
Point32[] points
================================================================================
MSG: geometry_msgs/Point32
float32 x
float32 y
float32 z
================================================================================
MSG: shape_msgs/SolidPrimitive
uint8 BOX=1
uint8 SPHERE=2
uint8 CYLINDER=3
uint8 CONE=4
uint8 type
float64[] dimensions
uint8 BOX_X=0
uint8 BOX_Y=1
uint8 BOX_Z=2
uint8 SPHERE_RADIUS=0
uint8 CYLINDER_HEIGHT=0
uint8 CYLINDER_RADIUS=1
uint8 CONE_HEIGHT=0
uint8 CONE_RADIUS=1
)";

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
