#include "protocols/strict.h"

#include <cmath>

namespace forge {

TypeDefinitions withOpenApproach(TypeDefinitions definitions) {
  for (auto& [type, definition] : definitions) {
    definition.min_approach = 0.0;
    definition.max_approach = M_PI;
  }
  return definitions;
}

StrictOutcome strictOutcome(const AttackerTrajectory& trajectory, const VerificationInput& input,
                            const AttackOptions& options) {
  AttackOptions angle_bands = options;
  angle_bands.collision_types = withOpenApproach(options.collision_types);
  StrictOutcome outcome;
  outcome.report = verify(trajectory, input, angle_bands);
  outcome.full_type_kept = verifyMotion(trajectory, input, options).type_kept;
  return outcome;
}

}  // namespace forge
