#pragma once

#include "collision_forge/attack/verify/verification.h"

namespace forge {

/// Result of the strict protocol, docs/protocols.md. The default value stands for a request without
/// an attack: no success.
struct StrictOutcome {
  /// Report of verify() with TypeRules::kAngle: type_kept tests only the band of |relative heading|
  /// at first contact.
  CollisionReport report;
  /// the contact meets the full definition of the type (TypeRules::kFull); false without a contact
  bool full_type_kept = false;
  bool is_plausible = true;  ///< the attack is plausible, or the request does not require that

  /// Returns true for a success with types defined by the heading at contact alone.
  bool meetsAngleBands() const { return report.verified() && is_plausible; }
  /// Returns true for a success with the full definition of the types.
  bool meetsFullDefinitions() const { return meetsAngleBands() && full_type_kept; }
};

/// Judges a trajectory by the strict protocol: the attacker touches the ego after t0, at a relative
/// heading of the requested type, within the tolerance of the requested time, within the limits of
/// the request's LimitSet from t0 to contact, touches no other agent before and, if the request
/// requires it, drives plausibly. `input.future` holds the recorded motion, not a prediction.
/// Decided by verify(), with interpolated headings and continuous contact detection. Throws as
/// verify().
StrictOutcome strictOutcome(const AttackerTrajectory& trajectory, const VerificationInput& input,
                            const VerificationOptions& options);

}  // namespace forge
