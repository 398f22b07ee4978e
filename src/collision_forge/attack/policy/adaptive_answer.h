#pragma once

#include <vector>

#include "collision_forge/attack/policy/adaptive_attacker.h"
#include "collision_forge/attack/search/attack_method.h"

namespace forge {

/// A fixed attack that sets out, and what becomes of it where the attacker sees and reacts.
struct AdaptiveAnswer {
  Realization attack;               ///< its trajectory is what was driven, its report tells of that
  std::vector<AttackerPlan> plans;  ///< AttackerPolicy::plans()
  std::vector<double> milliseconds;  ///< of the wall clock, that each look at a frame took
};

/// Asks the method for an attack as in history mode, however little it promises, and lets it drive
/// over the recording, which is revealed frame by frame. With kOk the drive was verified against
/// the recording (verify()), and may not be as asked. The moment is one of the recording.
AdaptiveAnswer answerAdaptively(const AttackMethod& method, const Moment& moment,
                                const Scene& recording, const EgoVehicle& ego,
                                const CollisionRequest& request, const AttackerSetup& setup);

/// The same with a first attack, status kOk, that was found already, verified or not.
AdaptiveAnswer driveAdaptively(Realization first, const Moment& moment, const Scene& recording,
                               const EgoVehicle& ego, const CollisionRequest& request,
                               const AttackerSetup& setup);

/// Declines, with the shortcoming, an answer whose drive turned out not to be as asked.
AdaptiveAnswer withoutMisses(AdaptiveAnswer answer, const CollisionRequest& request);

}  // namespace forge
