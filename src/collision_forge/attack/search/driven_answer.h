#pragma once

#include <functional>
#include <string>

#include "collision_forge/attack/search/judge.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/base/scene/moment.h"

/// Answers of methods that drive somewhere without a search, for baselines and learned generators.
namespace forge {

/// Throws std::invalid_argument for an agent that is not in the snapshot.
const Track& trackOf(const Snapshot& snapshot, const std::string& id);

/// Straight on from the last point for as long as `duration`, a point every `step` seconds.
void goStraightOn(AttackerTrajectory& trajectory, double duration, double step);

/// The answer that drives this; what a verification against the expected future says is in it, by
/// the strict limits. Whoever aims at no pattern aims at the contact that comes of it.
Realization drivenAnswer(AttackerTrajectory trajectory, const Moment& moment,
                         CollisionRequest request, const AttackOptions& options,
                         const CollisionPattern* aim = nullptr);

/// The answer of the attacker asked for. Without one that of the first candidate (isCandidate())
/// with the best answer: verified, else touching the ego, else any.
Realization bestOfCandidates(const Moment& moment, const CollisionRequest& request,
                             const PredictionOptions& options,
                             const std::function<Realization(const std::string&)>& answer_of);

}  // namespace forge
