#pragma once

#include <string>

namespace forge {

/// Effect of a crash on one party and its occupants or rider; see severityOf().
struct CrashEffect {
  double delta_v = 0.0;  ///< m/s, change of velocity of the centre of mass
  /// rad (-pi, pi], principal direction of force: where the force comes from, counter-clockwise
  /// from the party's heading.
  double force_from = 0.0;
  double yaw_rate_change = 0.0;  ///< rad/s, positive to the left
  double mais2 = 0.0;  ///< probability 0..1 of an injury of MAIS 2 or more; 0 without `curve`
  double mais3 = 0.0;  ///< probability 0..1 of an injury of MAIS 3 or more; 0 without `curve`
  std::string curve;   ///< name of the published injury curve; empty for a party without people (a
                       ///< trailer, an object)
  /// ISO 26262 class, 0 to 3 for S0 to S3, by the most lenient published bounds; like most_class 0
  /// without `curve`.
  int least_class = 0;
  int most_class = 0;  ///< ISO 26262 class, 0 to 3 for S0 to S3, by the strictest published bounds
};

/// Severity of a crash.
struct CrashSeverity {
  CrashEffect ego;
  CrashEffect other;         ///< the attacker or another agent
  double energy_lost = 0.0;  ///< J, kinetic energy lost in the impact

  /// Returns the effect with the larger probability of an injury of MAIS 3 or more, `ego` if they
  /// are equal; crashes are sorted by that probability.
  const CrashEffect& worse() const { return other.mais3 > ego.mais3 ? other : ego; }
};

/// Returns the clock hour, 1..12, nearest to a principal direction of force (rad,
/// CrashEffect::force_from): 12 from ahead, 3 from the right.
int clockHour(double force_from);

/// Returns the class of ISO 26262: "S1", or "S1 to S2" if the bounds differ; "S0" for a party
/// without people.
std::string severityClass(const CrashEffect& effect);

/// Returns delta-v and clockHour(), for example "5.3 m/s from 6 o'clock".
std::string deltaVText(const CrashEffect& effect);

/// Returns `mais3`, `curve` and severityClass(), for example "MAIS 3+ 1.2 % (CURVE), S1", or "" for
/// a party without people.
std::string injuryText(const CrashEffect& effect);

}  // namespace forge
