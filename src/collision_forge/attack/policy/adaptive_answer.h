#pragma once

#include <vector>

#include "collision_forge/attack/policy/adaptive_attacker.h"
#include "collision_forge/attack/search/attack_method.h"

namespace forge {

/// Result of driving an adaptive attacker over a recording.
struct AdaptiveAnswer {
  Realization attack;                ///< trajectory as driven, with its report
  std::vector<AttackerPlan> plans;   ///< AttackerPolicy::plans()
  std::vector<double> milliseconds;  ///< wall-clock time of each update step
};

/// Requests an attack from `method` as in history mode, without a minimum confidence, and drives it
/// adaptively over `recording`, revealed frame by frame. If the status is kOk, the drive was
/// verified against the recording (verify()) but may not meet the request: see withoutMisses().
/// `moment` must be an instant of `recording` and hold its recorded future.
AdaptiveAnswer answerAdaptively(const AttackMethod& method, const Moment& moment,
                                const Scene& recording, const EgoVehicle& ego,
                                const CollisionRequest& request, const AttackerSetup& setup);

/// As answerAdaptively(), from the first attack `first` with status kOk, verified or not.
AdaptiveAnswer driveAdaptively(Realization first, const Moment& moment, const Scene& recording,
                               const EgoVehicle& ego, const CollisionRequest& request,
                               const AttackerSetup& setup);

/// Returns `answer`, or kNoAttackWithinLimits with the reason if its drive does not meet `request`.
AdaptiveAnswer withoutMisses(AdaptiveAnswer answer, const CollisionRequest& request);

}  // namespace forge
