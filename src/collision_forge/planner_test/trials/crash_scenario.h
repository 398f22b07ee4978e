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
  Snapshot snapshot;  ///< frames up to t0 (`snapshot.now`) of the ego and of all agents
  Future recorded;    ///< recorded ego and other agents from t0 on; may contain the attacker's
                      ///< recorded track, which is ignored
  /// Middle of the box, from t0 to the end of the test; replaces its recorded track.
  AttackerTrajectory attacker;
  CollisionType type = CollisionType::kRearEnd;  ///< requested type
  EgoVehicle ego;                                ///< dimensions of the ego
  std::shared_ptr<const LaneIndex> lanes;        ///< the map
  std::vector<TrafficLight> lights = {};         ///< of the scene, as Scene::lights
  Turning turning = Turning::kAttacker;          ///< requested: the vehicle that must turn

  /// Returns the time of the attacker's last point, the end of a test. `attacker.points` must not
  /// be empty.
  double end() const { return attacker.points.back().time; }
};

/// Returns the attacker's trajectory as a track from t0 on, with the class that the agent has in
/// the snapshot, if it was recorded.
Track attackerTrack(const CrashScenario& scenario);

/// Returns all agents except the ego from t0 on: the attacker on its trajectory first, then the
/// others as recorded.
std::vector<Track> agentsFromT0(const CrashScenario& scenario);

/// Returns the Track::id of the agents, except the attacker, whose recorded boxes overlap the ego's
/// at t0; agents that are not in sight then are left out. Such overlaps occur in recordings and do
/// not count as contacts. The recorded ego must have a state.
std::set<std::string> agentsOverlappingEgoAtT0(const CrashScenario& scenario);

/// If the attacker was added to the scene, appends a track with its past states to
/// `snapshot.agents`; a recorded attacker changes nothing.
void addAttackerPast(CrashScenario& scenario);

/// Throws std::invalid_argument with the reason if no rollout of the scenario is possible: no
/// lanes, fewer than two attacker points, no ego at t0, attacker points whose times do not
/// increase, or an attacker that does not start at t0 (to 1e-5 s) or touches the ego then.
void checkScenario(const CrashScenario& scenario);

}  // namespace forge
