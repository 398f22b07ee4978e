#pragma once

#include <functional>
#include <string>

#include "collision_forge/attack/search/judge.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/base/scene/moment.h"

/// Attacks of methods that drive without a search: baselines and learned generators.
namespace forge {

/// Returns the track of agent `id`. Throws std::invalid_argument if it is not in the snapshot.
const Track& trackOf(const Snapshot& snapshot, const std::string& id);

/// Appends points every `step` s for `duration` s, straight on from the last point at its speed.
/// `trajectory` must have points.
void goStraightOn(AttackerTrajectory& trajectory, double duration, double step);

/// Returns the attack that drives `trajectory`, with the report of verify() against the recorded or
/// predicted future under the strict limits. Without `aim`, its pattern is the contact found.
Realization drivenAnswer(AttackerTrajectory trajectory, const Moment& moment,
                         CollisionRequest request, const AttackOptions& options,
                         const CollisionPattern* aim = nullptr);

/// Returns the attack of the requested attacker. Without one, calls `answer_of` for each candidate
/// (isCandidate()) and returns the first with the best result: verified, else touching the ego,
/// else any. Returns kNoCandidate if there is no candidate.
Realization bestOfCandidates(const Moment& moment, const CollisionRequest& request,
                             const PredictionOptions& options,
                             const std::function<Realization(const std::string&)>& answer_of);

}  // namespace forge
