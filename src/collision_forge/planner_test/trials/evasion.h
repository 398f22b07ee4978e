#pragma once

#include <optional>
#include <vector>

#include "collision_forge/planner_test/trials/avoidability.h"
#include "collision_forge/planner_test/trials/rollout.h"

namespace forge {

/// An evasive manoeuvre against an adaptive attacker.
struct Evasion {
  Avoidance ego;  ///< until its start the ego drives as in the rollout; kKeeping: at its speed at
                  ///< the start
  AttackerTrajectory attacker;  ///< its reaction to that motion, from t0 on
};

/// Searches for an evasive manoeuvre of an ego that was hit by the setup's attacker: the ego
/// deviates from `driven` at a start time and the attacker reacts in closed loop. Returns the
/// manoeuvre with the latest start, out of t0 and every `interval` later, or nothing if none is
/// found (which proves nothing).
/// - `driven`: the ego in a rollout of the scenario with this setup, from t0 to contact.
/// - At each start, tries at most `tries` plans of EvasiveDrives that touch no agent if the
///   attacker keeps its current plan: first those that stay on the road, among them those farthest
///   from it.
/// - Every witness is verified against the simulated attacker and other agents up to the scenario's
///   end: continuous contact and every limit of the ego. Agents that overlap the ego at t0, except
///   the attacker, are ignored.
/// Deterministic. Throws as checkScenario() and routeOf().
std::optional<Evasion> findEvasion(const CrashScenario& scenario,
                                   const std::vector<TrajectoryPoint>& driven,
                                   const RolloutSetup& setup);

/// Returns the ego's whole motion: `driven` up to the start of the evasive manoeuvre, then
/// `evasion`.
std::vector<TrajectoryPoint> wholeEvasion(const std::vector<TrajectoryPoint>& driven,
                                          const Avoidance& evasion);

}  // namespace forge
