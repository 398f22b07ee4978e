#pragma once

#include <optional>
#include <vector>

#include "collision_forge/trials/avoidability.h"
#include "collision_forge/trials/rollout.h"

namespace forge {

/// A motion of the ego that escapes an attacker who sees and reacts.
struct Escape {
  Avoidance ego;
  AttackerTrajectory attacker;  ///< as it drove against that, from the scenario's now on
};

/// Looks for a motion by which an ego that was hit by an attacker who sees and reacts would have
/// escaped it: the ego leaves what it drove at an instant, the attacker reacts to that in closed
/// loop. `driven`: the ego in a rollout of the scenario by this setup, from now to the contact,
/// with the setup's attacker. Tried at an instant are the plans of findAvoidability() that touch
/// nobody if the attacker goes on with what it then means to do: those that stay farthest from it,
/// `tries` at most. The answer's start is the latest, of now and each `interval` later, from which
/// one works. Every witness is verified against attacker and others as they drove in that loop, up
/// to the scenario's end: continuous contact and every limit of the ego. Who overlaps the ego
/// already now is not looked at. Empty where none is found, which proves nothing. Deterministic.
std::optional<Escape> findEscape(const CrashScenario& scenario,
                                 const std::vector<TrajectoryPoint>& driven,
                                 const RolloutSetup& setup);

}  // namespace forge
