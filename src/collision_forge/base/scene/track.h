#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_forge/base/geometry/oriented_box.h"

namespace forge {

/// Class of a road user or object.
enum class AgentClass {
  kCar,
  kTruck,
  kBus,
  kTrailer,  ///< without the vehicle that tows it, which is another agent
  kConstructionVehicle,
  kEmergencyVehicle,
  kMotorcycle,
  kBicycle,
  kPedestrian,
  kAnimal,
  kStaticObject,  ///< anything else, for instance a barrier or debris
  kChild,         ///< on foot
  kRunner,        ///< adult on foot who runs
  kScooter,       ///< e-scooter or other personal mobility device, with its rider
};
inline constexpr AgentClass kLastAgentClass = AgentClass::kScooter;

/// Returns the lower-case name as in messages and files, for instance "construction_vehicle".
const char* toString(AgentClass agent_class);
/// Returns the class of a name as toString() spells it; nullopt for another name.
std::optional<AgentClass> agentClassFromString(const std::string& name);
/// Classes that can be the attacker. The last five, cycles (isCycle()) and people on foot
/// (isOnFoot()), are attackers only if the request names the class or the agent.
inline constexpr AgentClass kAttackerClasses[] = {
    AgentClass::kCar,
    AgentClass::kTruck,
    AgentClass::kBus,
    AgentClass::kConstructionVehicle,
    AgentClass::kEmergencyVehicle,
    AgentClass::kMotorcycle,
    AgentClass::kBicycle,
    AgentClass::kPedestrian,
    AgentClass::kChild,
    AgentClass::kRunner,
    AgentClass::kScooter,
};
/// Returns true for the classes of kAttackerClasses.
bool canAttack(AgentClass agent_class);
/// Returns true for pedestrians, children and runners.
bool isOnFoot(AgentClass agent_class);
/// Returns true for bicycles and scooters.
bool isCycle(AgentClass agent_class);
/// Returns true for the attacker classes but cycles and people on foot; so not for trailers.
bool isMotorVehicle(AgentClass agent_class);
/// Returns true for all classes but people on foot, animals and static objects; so also for
/// trailers and cycles.
bool isVehicle(AgentClass agent_class);
/// Returns true for motor vehicles but motorcycles.
bool isCarLike(AgentClass agent_class);

/// Returns the typical height (m) of a class and box size, for boxes of unknown height.
double typicalHeight(AgentClass agent_class, const BoxSize& size);

/// State of one agent at one time. Global map frame; `pose` is the centre of the box.
struct AgentState {
  double time = 0.0;  ///< s, scene clock: one clock for a whole scene, ROS time or the log's time
  Pose2 pose;
  Vector2 velocity{0.0, 0.0};  ///< m/s, global map frame
};

/// The states of one agent, with strictly increasing times; code that adds states must keep this
/// order.
struct Track {
  std::string id;  ///< unique in a scene; kEgoId for the ego
  AgentClass agent_class = AgentClass::kCar;
  BoxSize size;
  std::vector<AgentState> states;
  std::optional<double> height = {};  ///< m, of the box; empty if the log has none
};

/// s; stateAt() does not interpolate between states farther apart than this.
inline constexpr double kMaxGap = 1.1;

/// Returns the state at `time` (s, scene clock), interpolated: position and velocity linearly, yaw
/// along the shorter turn. Returns nullopt before the first and after the last state (without
/// tolerance), so always for a track without states, and between states more than `max_gap` (s)
/// apart.
std::optional<AgentState> stateAt(const Track& track, double time, double max_gap = kMaxGap);

/// Returns true if the track's last state is at `time` (s, to 1 us); false for a track without
/// states.
bool endsAt(const Track& track, double time);

/// Sets each velocity from the positions by central differences; one-sided at the ends and beside
/// gaps above `max_gap` (s), zero for a state without a neighbour.
void deriveVelocities(Track& track, double max_gap = kMaxGap);

/// Returns the track's height (m), or a typical one if it is unknown.
inline double heightOf(const Track& track) {
  return track.height.value_or(typicalHeight(track.agent_class, track.size));
}

/// Returns the box of the track's size, centred at `pose`.
inline OrientedBox boxAt(const Track& track, const Pose2& pose) { return {pose, track.size}; }

}  // namespace forge
