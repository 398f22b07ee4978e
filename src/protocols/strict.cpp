#include "protocols/strict.h"

namespace forge {

AttackOptions withAngleRules(AttackOptions options) {
  options.type_rules = TypeRules::kAngle;
  return options;
}

StrictOutcome strictOutcome(const AttackerTrajectory& trajectory, const VerificationInput& input,
                            const AttackOptions& options) {
  AttackOptions full = options;
  full.type_rules = TypeRules::kFull;
  StrictOutcome outcome;
  outcome.report = verify(trajectory, input, withAngleRules(options));
  outcome.full_type_kept = verifyMotion(trajectory, input, full).type_kept;
  return outcome;
}

}  // namespace forge
