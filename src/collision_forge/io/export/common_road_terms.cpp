#include "collision_forge/io/export/common_road_terms.h"

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "collision_forge/io/export/xml.h"
#include "collision_forge/io/maps/common_road_file.h"

namespace forge {
namespace {

constexpr int kDecimals = 6;                  // for m, rad, m/s and s
constexpr double kStraightTurn = M_PI / 6.0;  // rad; lanes that turn more are left or right turns

/// Returns the country of a location by its prefix; else Zamunda, CommonRoad's fictitious country.
const char* countryOf(const std::string& location) {
  if (location.rfind("boston", 0) == 0) return "USA";
  if (location.rfind("singapore", 0) == 0) return "SGP";
  return "ZAM";
}

/// Returns the letters and digits of a name in camel case.
std::string joinedWords(const std::string& name) {
  std::string joined;
  bool is_first = true;
  for (const unsigned char letter : name) {
    const bool is_kept = std::isalnum(letter) != 0;
    if (is_kept) joined += static_cast<char>(is_first ? std::toupper(letter) : letter);
    is_first = !is_kept;
  }
  return joined;
}

}  // namespace

std::string decimal(double value) {
  if (!std::isfinite(value)) throw std::invalid_argument("a number for XML is not finite");
  std::array<char, 512> buffer;
  char* const end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                  std::chars_format::fixed, kDecimals)
                        .ptr;
  std::string text(buffer.data(), end);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

const char* staticTypeOf(AgentClass agent_class) {
  switch (agent_class) {
    case AgentClass::kPedestrian:
    case AgentClass::kChild:
    case AgentClass::kRunner:
    case AgentClass::kAnimal:
      return "";
    case AgentClass::kStaticObject:
      return "unknown";
    default:
      return "parkedVehicle";
  }
}

const char* dynamicTypeOf(AgentClass agent_class) {
  switch (agent_class) {
    case AgentClass::kCar:
      return "car";
    case AgentClass::kTruck:
    case AgentClass::kTrailer:
    case AgentClass::kConstructionVehicle:
      return "truck";
    case AgentClass::kBus:
      return "bus";
    case AgentClass::kEmergencyVehicle:
      return "priorityVehicle";
    case AgentClass::kMotorcycle:
      return "motorcycle";
    case AgentClass::kBicycle:
    case AgentClass::kScooter:
      return "bicycle";
    case AgentClass::kPedestrian:
    case AgentClass::kChild:
    case AgentClass::kRunner:
      return "pedestrian";
    case AgentClass::kAnimal:
    case AgentClass::kStaticObject:
      break;
  }
  return "unknown";
}

const char* nameOf(LightColor color) {
  switch (color) {
    case LightColor::kRed:
      return "red";
    case LightColor::kYellow:
      return "yellow";
    case LightColor::kGreen:
      return "green";
    case LightColor::kUnknown:
      break;
  }
  return "inactive";
}

const char* directionOf(const Lane& lane) {
  if (lane.centerline.size() < 2) return "all";
  const double turn = angleBetween(lane.centerline.front().yaw, lane.centerline.back().yaw);
  if (std::abs(turn) < kStraightTurn) return "straight";
  return turn > 0.0 ? "left" : "right";
}

std::string benchmarkOf(const CrashRecord& record) {
  const std::string& location = record.lanes.location;
  const std::string line = record.name.substr(record.name.rfind('_') + 1);
  return std::string(countryOf(location)) + "_" + joinedWords(location) +
         joinedWords(record.scenario.asked.scene) + "-1_" + line + "_T-1";
}

std::string sourceOf(const CrashRecord& record) {
  const SceneRequest& asked = record.scenario.asked;
  std::string source = "scene=" + asked.scene + "; type=" + toString(asked.request.type) +
                       "; tta=" + decimal(asked.request.tta) +
                       "; manoeuvre=" + toString(record.scenario.answer.report.manoeuvre) +
                       "; attacker=" + record.attacker.id +
                       "; seed=" + std::to_string(asked.request.seed) +
                       "; now=" + decimal(record.now) + "; " + kDrivingSideKey +
                       (record.lanes.driving_side == DrivingSide::kLeft ? "left" : "right");
  if (record.contact) source += "; contact=" + decimal(*record.contact);
  return source;
}

std::set<std::string> tagsOf(const CrashRecord& record) {
  std::set<std::string> tags = {"critical", "simulated", "urban"};
  switch (record.scenario.asked.request.type) {
    case CollisionType::kLaneChange:
      tags.insert("lane_change");
      break;
    case CollisionType::kOppositeDirection:
      tags.insert("oncoming_traffic");
      break;
    case CollisionType::kRearEnd:
      tags.insert("lane_following");
      break;
    case CollisionType::kJunctionCrossing:
      tags.insert("intersection");
      break;
    case CollisionType::kSideswipeSameDirection:
      tags.insert("lane_change");
      break;
    case CollisionType::kAngleSameDirection:
      tags.insert("intersection");
      break;
    case CollisionType::kAngleOppositeDirection:
      tags.insert("oncoming_traffic");
      break;
    case CollisionType::kAny:
      break;
    case CollisionType::kLtap:
      tags.insert({"intersection", "oncoming_traffic"});
      break;
  }
  const Manoeuvre manoeuvre = record.scenario.answer.report.manoeuvre;
  if (manoeuvre == Manoeuvre::kCutIn) tags.insert("cut_in");
  if (manoeuvre == Manoeuvre::kMerge) tags.insert("merging_lanes");
  return tags;
}

}  // namespace forge
