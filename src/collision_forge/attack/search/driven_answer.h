#pragma once

#include <functional>
#include <string>

#include "collision_forge/attack/search/judge.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/base/scene/moment.h"

/// Attacks of methods that drive without a search: baselines and learned generators.
namespace forge {

/// Returns the track of agent `id`, valid as long as `snapshot`. Throws std::invalid_argument if it
/// is not in the snapshot.
const Track& trackOf(const Snapshot& snapshot, const std::string& id);

/// Appends points every `step` s for `duration` s (rounded to whole steps), straight on from the
/// last point at its speed. `trajectory` must have points; `step` must be positive.
void goStraightOn(AttackerTrajectory& trajectory, double duration, double step);

/// Returns the attack that drives `trajectory`, with the report of verify() against the recorded or
/// predicted future under the strict limits; status kOk, whether it hits or not. Its pattern is
/// `*aim`; if `aim` is null, the contact found, without a contact one with default poses and time
/// 0. Throws as verify().
Attack drivenAttack(AttackerTrajectory trajectory, const Moment& moment, CollisionRequest request,
                    const AttackOptions& options, const CollisionPattern* aim = nullptr);

/// Returns `answer_of` for the requested attacker's id, on the caller's thread. Without one, calls
/// `answer_of` with the id of each candidate (isCandidate()) of the requested class, in the order
/// of the snapshot, and returns the first with the best result: verified, else touching the ego,
/// else any; all candidates are tried. Returns kNoCandidate if there is no candidate.
Attack bestOfCandidates(const Moment& moment, const CollisionRequest& request,
                        const PredictionOptions& options,
                        const std::function<Attack(const std::string&)>& answer_of);

}  // namespace forge
