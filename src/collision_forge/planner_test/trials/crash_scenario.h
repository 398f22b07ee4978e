#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// A generated crash in which a planner can drive the ego. All times on the scene clock, s.
struct CrashScenario {
  Snapshot snapshot;                             ///< scene up to t0
  Future recorded;                               ///< recorded ego and other agents from t0 on
  AttackerTrajectory attacker;                   ///< from t0 on; replaces its recorded track
  CollisionType type = CollisionType::kRearEnd;  ///< requested
  EgoVehicle ego;
  std::shared_ptr<const LaneIndex> lanes;
  std::vector<TrafficLight> lights = {};  ///< as Scene::lights
  Turning turning = Turning::kAttacker;   ///< requested, of kLtap

  /// Returns the time of the attacker's last point. `attacker.points` must not be empty.
  double end() const { return attacker.points.back().time; }
};

/// Returns the attacker's trajectory as a track from t0 on.
Track attackerTrack(const CrashScenario& scenario);

/// Returns all agents except the ego from t0 on: the attacker on its trajectory first, then the
/// others as recorded.
std::vector<Track> agentsFromT0(const CrashScenario& scenario);

/// Returns the ids of the agents, except the attacker, whose recorded boxes overlap the ego's at
/// t0. Such overlaps occur in recordings and do not count as contacts.
std::set<std::string> agentsOverlappingEgoAtT0(const CrashScenario& scenario);

/// If the attacker was added to the scene, adds its past states to the snapshot.
void addAttackerPast(CrashScenario& scenario);

/// Throws std::invalid_argument with the reason if no rollout of the scenario is possible: no
/// lanes, no attacker points, no ego at t0, times that do not increase, or an attacker that does
/// not start at t0 or touches the ego then.
void checkScenario(const CrashScenario& scenario);

}  // namespace forge
