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
  kTrailer,
  kConstructionVehicle,
  kEmergencyVehicle,
  kMotorcycle,
  kBicycle,
  kPedestrian,
  kAnimal,
  kStaticObject,
  kChild,    ///< on foot
  kRunner,   ///< adult on foot who runs
  kScooter,  ///< e-scooter or other personal mobility device, with its rider
};
inline constexpr AgentClass kLastAgentClass = AgentClass::kScooter;

/// Lower-case name as in messages and files, for instance "construction_vehicle".
const char* toString(AgentClass agent_class);
/// Returns the class of a name as toString() spells it; nullopt for another name.
std::optional<AgentClass> agentClassFromString(const std::string& name);
/// Classes that can be the attacker. The last five are attackers only if the request names them.
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
/// Returns true for kAttackerClasses.
bool canAttack(AgentClass agent_class);
/// Returns true for pedestrians, children and runners.
bool isOnFoot(AgentClass agent_class);
/// Returns true for bicycles and scooters.
bool isCycle(AgentClass agent_class);
/// Returns true for the attacker classes but cycles and people on foot.
bool isMotorVehicle(AgentClass agent_class);
/// Returns true for all classes but people on foot, animals and static objects.
bool isVehicle(AgentClass agent_class);
/// Returns true for motor vehicles but motorcycles.
bool isCarLike(AgentClass agent_class);

/// Returns the typical height (m) of a class and box size, for boxes of unknown height.
double typicalHeight(AgentClass agent_class, const BoxSize& size);

/// State of one agent at one time. Global map frame; `pose` is the centre of the box.
struct AgentState {
  double time = 0.0;  ///< seconds; one clock for a whole scene
  Pose2 pose;
  Vector2 velocity{0.0, 0.0};  ///< m/s, global map frame
};

/// The states of one agent, times strictly increasing.
struct Track {
  std::string id;
  AgentClass agent_class = AgentClass::kCar;
  BoxSize size;
  std::vector<AgentState> states;
  std::optional<double> height = {};  ///< m, of the box; empty if the log has none
};

/// s; states farther apart than this are not interpolated.
inline constexpr double kMaxGap = 1.1;

/// Returns the state at `time` (s), interpolated: pose and velocity linearly, yaw along the shorter
/// turn. Returns nullopt outside the track's times and in gaps above `max_gap` (s).
std::optional<AgentState> stateAt(const Track& track, double time, double max_gap = kMaxGap);

/// Returns true if the track's last state is at `time` (to 1 us).
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
