#pragma once

#include "attack/verification.h"

namespace forge {

/// The conditions of a crash as asked, each and together; docs/protocols.md. Without an attack all
/// are missed.
struct StrictOutcome {
  /// Every condition, the type by its band of |relative heading| at first contact alone.
  CollisionReport report;
  bool full_type_kept = false;  ///< the type's approach band at now is kept as well

  bool meetsAngleBands() const { return report.verified(); }
  bool meetsFullDefinitions() const { return report.verified() && full_type_kept; }
};

/// The type definitions with every approach band opened to [0, pi]. COLLIDE tells its types apart
/// by the relative heading at contact, so its clips are searched and measured with these.
TypeDefinitions withOpenApproach(TypeDefinitions definitions);

/// The strict protocol: the attacker touches the ego after now; at a relative heading of the type;
/// at most `time_tolerance` before or after the time asked for; within a real car's limits from now
/// to contact; and touches nobody earlier. `input.future` is what came: recorded, not predicted.
/// Headings are interpolated and contact is continuous, as in verify(), which decides all of it.
StrictOutcome strictOutcome(const AttackerTrajectory& trajectory, const VerificationInput& input,
                            const AttackOptions& options);

}  // namespace forge
