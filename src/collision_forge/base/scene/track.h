#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_forge/base/geometry/oriented_box.h"

namespace forge {

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
};

/// Lower-case name as in messages and files, for instance "construction_vehicle".
const char* toString(AgentClass agent_class);
std::optional<AgentClass> agentClassFromString(const std::string& name);
/// What can be made to attack.
inline constexpr AgentClass kAttackerClasses[] = {AgentClass::kCar,
                                                  AgentClass::kTruck,
                                                  AgentClass::kBus,
                                                  AgentClass::kConstructionVehicle,
                                                  AgentClass::kEmergencyVehicle,
                                                  AgentClass::kMotorcycle};
bool canAttack(AgentClass agent_class);
/// All but people, animals and things.
bool isVehicle(AgentClass agent_class);
/// Attackers with a car's body: all but motorcycles.
bool isCarLike(AgentClass agent_class);

/// One agent at one instant. Global map frame; `pose` is the middle of the box.
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
};

/// s; over a longer gap between two states nobody knows how an agent moved.
inline constexpr double kMaxGap = 1.1;

/// State at `time`, interpolated (pose and velocity linear, yaw along the shorter turn).
/// Empty before the first and after the last state, and within a gap longer than `max_gap` seconds.
std::optional<AgentState> stateAt(const Track& track, double time, double max_gap = kMaxGap);

/// True when the track has a state at `time` (to a microsecond) as its newest.
bool newestAt(const Track& track, double time);

/// Velocities from positions by central differences (one-sided at the ends and beside gaps longer
/// than `max_gap` seconds; zero for a lone state).
void deriveVelocities(Track& track, double max_gap = kMaxGap);

/// The box of `track` at a pose.
inline OrientedBox boxAt(const Track& track, const Pose2& pose) { return {pose, track.size}; }

}  // namespace forge
