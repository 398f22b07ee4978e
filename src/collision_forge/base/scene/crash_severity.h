#pragma once

#include <string>

namespace forge {

/// Effect of a crash on one party and its occupants or rider; see severityOf().
struct CrashEffect {
  double delta_v = 0.0;  ///< m/s, change of velocity of the centre of mass
  /// rad (-pi, pi], principal direction of force: where the force comes from, counter-clockwise
  /// from the party's heading.
  double force_from = 0.0;
  double yaw_rate_change = 0.0;  ///< rad/s
  double mais2 = 0.0;            ///< probability 0..1 of an injury of MAIS 2 or more
  double mais3 = 0.0;            ///< probability 0..1 of an injury of MAIS 3 or more
  std::string curve;             ///< published injury curve; empty for a party without people
  int least_class = 0;           ///< ISO 26262: S0 to S3, by the most lenient published bounds
  int most_class = 0;            ///< ISO 26262: S0 to S3, by the strictest published bounds
};

/// Severity of a crash.
struct CrashSeverity {
  CrashEffect ego;
  CrashEffect other;         ///< the attacker or another agent
  double energy_lost = 0.0;  ///< J

  /// Returns the effect with the larger probability of an injury of MAIS 3 or more; crashes are
  /// sorted by that.
  const CrashEffect& worse() const { return other.mais3 > ego.mais3 ? other : ego; }
};

/// Returns the clock hour, 1..12, of a principal direction of force: 12 from ahead, 3 from the
/// right.
int clockHour(double force_from);

/// Returns "S1", or "S1 to S2" if the bounds differ.
std::string severityClass(const CrashEffect& effect);

/// Returns "5.3 m/s from 6 o'clock".
std::string deltaVText(const CrashEffect& effect);

/// Returns "MAIS 3+ 1.2 % (CURVE), S1", or "" for a party without people.
std::string injuryText(const CrashEffect& effect);

}  // namespace forge
