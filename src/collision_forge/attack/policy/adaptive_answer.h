#pragma once

#include <vector>

#include "collision_forge/attack/policy/adaptive_attacker.h"
#include "collision_forge/attack/search/attack_method.h"

namespace forge {

/// Result of driving an adaptive attacker over a recording. Without an attack `plans` and
/// `milliseconds` are empty.
struct AdaptiveDrive {
  Attack attack;                    ///< trajectory as driven, with its report; or the rejection
  std::vector<AttackerPlan> plans;  ///< AttackerPolicy::plans(), the initial plan first
  /// wall-clock time of each call of AttackerPolicy::observe(), ms; one per frame after t0
  std::vector<double> milliseconds;
};

/// Requests an attack from `method` as in history mode, without a minimum confidence, and drives it
/// adaptively over `recording`, revealed frame by frame. If the status is kOk, the drive was
/// verified against the recording (verify()) but may not meet the request: see rejectMisses(). If
/// the method finds no attack, returns its rejection. `moment` must be an instant of `recording`
/// and hold its recorded future. `ego`: size of the ego's box. `request` needs its crash
/// definition; for kAny, the drive keeps the type of the attack that the method found.
AdaptiveDrive requestAdaptively(const AttackMethod& method, const Moment& moment,
                                const Scene& recording, const EgoVehicle& ego,
                                const CollisionRequest& request, const AttackerSetup& setup);

/// As requestAdaptively(), from the first attack `first`, which must have the status kOk, verified
/// or not; its pattern and confidence are kept. With a contact, the report has careful_drivers.
/// `request.type` must not be kAny.
AdaptiveDrive driveAdaptively(Attack first, const Moment& moment, const Scene& recording,
                              const EgoVehicle& ego, const CollisionRequest& request,
                              const AttackerSetup& setup);

/// Returns `answer` if it is rejected already or its drive meets `request` (shortcomingOf()), else
/// a rejection without plans and milliseconds: kNoAttackWithinLimits (also if only plausibility
/// fails), with the shortcoming and the reason of the last plan as message.
AdaptiveDrive rejectMisses(AdaptiveDrive answer, const CollisionRequest& request);

}  // namespace forge
