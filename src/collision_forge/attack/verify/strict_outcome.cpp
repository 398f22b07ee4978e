#include "collision_forge/attack/verify/strict_outcome.h"

namespace forge {

StrictOutcome strictOutcome(const AttackerTrajectory& trajectory, const VerificationInput& input,
                            const VerificationOptions& options) {
  CollisionRequest request = input.request;
  const VerificationInput asked{input.snapshot, input.future, request, input.lanes};
  StrictOutcome outcome;
  request.crash.rules = TypeRules::kAngle;
  outcome.report = verify(trajectory, asked, options);
  outcome.is_plausible = !request.crash.believable || outcome.report.believable();
  request.crash.rules = TypeRules::kFull;
  outcome.full_type_kept = verifyMotion(trajectory, asked, options).type_kept;
  return outcome;
}

}  // namespace forge
