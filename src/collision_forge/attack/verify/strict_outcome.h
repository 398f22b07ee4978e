#pragma once

#include "collision_forge/attack/verify/verification.h"

namespace forge {

/// The conditions of a crash as asked, each and together; docs/protocols.md. Without an attack all
/// are missed.
struct StrictOutcome {
  /// Every condition, the type by its band of |relative heading| at first contact alone.
  CollisionReport report;
  bool full_type_kept = false;  ///< the whole definition of the type is kept
  bool is_believed = true;      ///< a driver would do it, or the request does not ask for that

  bool meetsAngleBands() const { return report.verified() && is_believed; }
  bool meetsFullDefinitions() const { return meetsAngleBands() && full_type_kept; }
};

/// The strict protocol: the attacker touches the ego after now; at a relative heading of the type;
/// at most the tolerance before or after the time asked for; within the limits of the request's
/// LimitSet from now to contact; touches nobody earlier; and, where the request asks for it, drives
/// as a driver would. `input.future` is what came: recorded, not predicted.
/// Headings are interpolated and contact is continuous, as in verify(), which decides all of it.
StrictOutcome strictOutcome(const AttackerTrajectory& trajectory, const VerificationInput& input,
                            const VerificationOptions& options);

}  // namespace forge
