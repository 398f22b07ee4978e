#pragma once

#include <optional>
#include <vector>

#include "collision_forge/planner_test/trials/avoidability.h"
#include "collision_forge/planner_test/trials/rollout.h"

namespace forge {

/// A motion of the ego that escapes an attacker who sees and reacts.
struct Escape {
  Avoidance ego;  ///< until its start the ego drives as it did; kKeeping: at its speed of then
  AttackerTrajectory attacker;  ///< as it drove against that, from the scenario's now on
};

/// Looks for a motion by which an ego that was hit would have escaped the setup's attacker: the ego
/// leaves what it drove at an instant, and the attacker reacts to that in closed loop. `driven`:
/// the ego in a rollout of the scenario by this setup, from now to the contact. Tried at an instant
/// are the plans of EvasiveDrives that touch nobody if the attacker goes on with what it then means
/// to do: first those that stay on the road, of these those that stay farthest from it, `tries` at
/// most. The answer's start is the latest, of now and each `interval` later, from which one works.
/// Every witness is verified against attacker and others as they drove in that loop, up to the
/// scenario's end: continuous contact and every limit of the ego. Who overlaps the ego already now
/// is not looked at. Empty where none is found, which proves nothing. Deterministic. Throws as
/// checkScenario() and routeOf().
std::optional<Escape> findEscape(const CrashScenario& scenario,
                                 const std::vector<TrajectoryPoint>& driven,
                                 const RolloutSetup& setup);

/// What the ego does in place of `driven`: the same up to the start of the escape.
std::vector<TrajectoryPoint> wholeEscape(const std::vector<TrajectoryPoint>& driven,
                                         const Avoidance& escape);

}  // namespace forge
