#include "collision_forge/base/scene/track.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "collision_forge/base/geometry/enum_words.h"
#include "collision_forge/base/scene/clock.h"

namespace forge {
namespace {

constexpr EnumWord<AgentClass> kClassNames[] = {
    {AgentClass::kCar, "car"},
    {AgentClass::kTruck, "truck"},
    {AgentClass::kBus, "bus"},
    {AgentClass::kTrailer, "trailer"},
    {AgentClass::kConstructionVehicle, "construction_vehicle"},
    {AgentClass::kEmergencyVehicle, "emergency_vehicle"},
    {AgentClass::kMotorcycle, "motorcycle"},
    {AgentClass::kBicycle, "bicycle"},
    {AgentClass::kPedestrian, "pedestrian"},
    {AgentClass::kAnimal, "animal"},
    {AgentClass::kStaticObject, "static_object"},
    {AgentClass::kChild, "child"},
    {AgentClass::kRunner, "runner"},
    {AgentClass::kScooter, "scooter"},
};

}  // namespace

const char* toString(AgentClass agent_class) { return wordOf(kClassNames, agent_class); }

std::optional<AgentClass> agentClassFromString(const std::string& name) {
  return valueOf(kClassNames, name);
}

bool canAttack(AgentClass agent_class) {
  return std::find(std::begin(kAttackerClasses), std::end(kAttackerClasses), agent_class) !=
         std::end(kAttackerClasses);
}

bool isOnFoot(AgentClass agent_class) {
  return agent_class == AgentClass::kPedestrian || agent_class == AgentClass::kChild ||
         agent_class == AgentClass::kRunner;
}

bool isCycle(AgentClass agent_class) {
  return agent_class == AgentClass::kBicycle || agent_class == AgentClass::kScooter;
}

bool isMotorVehicle(AgentClass agent_class) {
  return canAttack(agent_class) && !isCycle(agent_class) && !isOnFoot(agent_class);
}

bool isVehicle(AgentClass agent_class) {
  return !isOnFoot(agent_class) && agent_class != AgentClass::kAnimal &&
         agent_class != AgentClass::kStaticObject;
}

bool isCarLike(AgentClass agent_class) {
  return isMotorVehicle(agent_class) && agent_class != AgentClass::kMotorcycle;
}

double typicalHeight(AgentClass agent_class, const BoxSize& size) {
  // m; a shorter truck is a van or a pick-up, as lengths.van of config/vehicle_limits.yaml
  constexpr double kLongestVan = 6.3;
  switch (agent_class) {
    // Medians of nuScenes' annotations (anchors of mmdetection3d's nuScenes models), unless said.
    case AgentClass::kCar:
      return 1.5;  // the parked cars of Euro NCAP's CPNCO have 1.48 and 1.53 m
    case AgentClass::kTruck:
      return size.length < kLongestVan ? 2.0 : 2.84;  // vans: own choice
    case AgentClass::kBus:
      return 3.47;
    case AgentClass::kTrailer:
      return 3.87;
    case AgentClass::kConstructionVehicle:
      return 3.19;
    case AgentClass::kEmergencyVehicle:
      return 2.0;  // as vans
    // With a rider, own choice: seat of the lidar body and an adult's sitting height, 0.9 m. The
    // medians of nuScenes, 1.47 and 1.28 m, are below the head of a rider.
    case AgentClass::kMotorcycle:
      return 0.8 + 0.9;
    case AgentClass::kBicycle:
      return 0.95 + 0.9;
    case AgentClass::kPedestrian:
    case AgentClass::kRunner:
      return 1.77;
    case AgentClass::kChild:
      return 1.15;  // Euro NCAP's child target
    case AgentClass::kScooter:
      return 1.87;  // median of the personal mobility devices of nuScenes' mini part
    case AgentClass::kAnimal:
      return 0.5;  // own choice
    case AgentClass::kStaticObject:
      break;
  }
  return 0.98;
}

std::optional<AgentState> stateAt(const Track& track, double time, double max_gap) {
  const auto& states = track.states;
  const auto after =
      std::lower_bound(states.begin(), states.end(), time,
                       [](const AgentState& state, double value) { return state.time < value; });
  if (after == states.end()) return std::nullopt;
  if (after->time == time) return *after;
  if (after == states.begin()) return std::nullopt;
  const AgentState& before = *std::prev(after);
  const double gap = after->time - before.time;
  if (gap > max_gap) return std::nullopt;
  const double ratio = (time - before.time) / gap;
  AgentState state;
  state.time = time;
  state.pose = interpolate(before.pose, after->pose, ratio);
  state.velocity = before.velocity + ratio * (after->velocity - before.velocity);
  return state;
}

bool endsAt(const Track& track, double time) {
  return !track.states.empty() && std::abs(track.states.back().time - time) <= kTimeEpsilon;
}

void deriveVelocities(Track& track, double max_gap) {
  auto& states = track.states;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const bool has_previous = i > 0 && states[i].time - states[i - 1].time <= max_gap;
    const bool has_next = i + 1 < states.size() && states[i + 1].time - states[i].time <= max_gap;
    const AgentState& first = has_previous ? states[i - 1] : states[i];
    const AgentState& last = has_next ? states[i + 1] : states[i];
    const double duration = last.time - first.time;
    states[i].velocity = Vector2::Zero();
    if (duration > 0.0) {
      states[i].velocity = (last.pose.position() - first.pose.position()) / duration;
    }
  }
}

}  // namespace forge
