#pragma once

#include <optional>
#include <vector>

#include "collision_forge/planner_test/trials/avoidability.h"
#include "collision_forge/planner_test/trials/rollout.h"

namespace forge {

/// An evasive manoeuvre against an adaptive attacker.
struct Evasion {
  Avoidance ego;  ///< motion of the ego; until its start the ego drives as in the rollout;
                  ///< kKeeping: keeps its speed at the start
  AttackerTrajectory attacker;  ///< its reaction to that motion, from t0 to the scenario's end
};

/// Searches for an evasive manoeuvre of an ego that was hit by the setup's attacker: the ego
/// deviates from `driven` at a start time and the attacker reacts in closed loop. Returns the
/// manoeuvre with the latest start, out of t0 and every `interval` later before the last point of
/// `driven`; nullopt if none is found, which does not prove that there is none. `interval` and
/// `tries`: setup.planners.avoidability. Deterministic. Throws as checkScenario(), routeOf() and
/// makeRolloutTraffic().
/// - `driven`: the ego in a rollout of the scenario with this setup (RolloutOutcome::driven), from
/// t0 to contact, one point per step.
/// - At each start, tries at most `tries` plans of EvasiveDrives that touch no agent if the
/// attacker keeps its current plan: first the plans that stay on the road, among them the plans
/// whose mean distance to the attacker is largest.
/// - Every witness is verified against the simulated attacker and other agents up to the scenario's
/// end: continuous contact and every limit of the ego. Agents that overlap the ego at t0, except
/// the attacker, are ignored.
std::optional<Evasion> findEvasion(const CrashScenario& scenario,
                                   const std::vector<TrajectoryPoint>& driven,
                                   const RolloutSetup& setup);

/// Returns the ego's whole motion: the points of `driven` before `evasion.start`, then
/// `evasion.motion`.
std::vector<TrajectoryPoint> wholeEvasion(const std::vector<TrajectoryPoint>& driven,
                                          const Avoidance& evasion);

}  // namespace forge
