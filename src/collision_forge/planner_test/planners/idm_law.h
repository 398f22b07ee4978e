#pragma once

#include <algorithm>
#include <cmath>

namespace forge {

/// Smallest gap (m) that callers pass to the law, which cannot divide by 0.
inline constexpr double kTouchingGap = 0.01;

/// Parameters of the intelligent driver model, not negative and, except `time_headway` and
/// `min_gap`, not 0 (Treiber, Hennecke, Helbing 2000, doi 10.1103/PhysRevE.62.1805).
struct IdmParameters {
  double desired_speed = 0.0;     ///< v0, m/s
  double time_headway = 0.0;      ///< T, s
  double max_acceleration = 0.0;  ///< a, m/s2
  double braking = 0.0;           ///< b, comfortable, m/s2, positive
  double min_gap = 0.0;           ///< s0, m
  double exponent = 0.0;          ///< delta, without unit
};

/// Returns the acceleration a (1 - (v/v0)^delta) on a free road, m/s2, at `speed` m/s (not negative
/// unless the exponent is an integer).
inline double idmFreeAcceleration(const IdmParameters& idm, double speed) {
  return idm.max_acceleration * (1.0 - std::pow(speed / idm.desired_speed, idm.exponent));
}

/// Returns the desired gap s* = s0 + v T + v dv / (2 sqrt(a b)), m; negative if the lead is much
/// faster. Speeds in m/s.
inline double idmDesiredGap(const IdmParameters& idm, double speed, double lead_speed) {
  return idm.min_gap + speed * idm.time_headway +
         speed * (speed - lead_speed) / (2.0 * std::sqrt(idm.max_acceleration * idm.braking));
}

/// Returns a (1 - (v/v0)^delta - (s*/gap)^2), m/s2, behind a lead at `lead_speed` m/s (along the
/// follower's path), `gap` metres ahead (not 0). A negative s* brakes as strongly as a positive
/// one.
inline double plainIdmAcceleration(const IdmParameters& idm, double speed, double lead_speed,
                                   double gap) {
  const double share = idmDesiredGap(idm, speed, lead_speed) / gap;
  return idmFreeAcceleration(idm, speed) - idm.max_acceleration * share * share;
}

/// As plainIdmAcceleration(), but clamps s* to >= 0, so that a lead that is much faster causes no
/// braking. `gap` must be positive.
inline double idmAcceleration(const IdmParameters& idm, double speed, double lead_speed,
                              double gap) {
  const double share = std::max(idmDesiredGap(idm, speed, lead_speed), 0.0) / gap;
  return idmFreeAcceleration(idm, speed) - idm.max_acceleration * share * share;
}

/// A lead relative to its follower.
struct IdmLead {
  /// m, bumper to bumper; may be negative once the follower has reached the lead
  double gap = 0.0;
  double speed = 0.0;  ///< m/s along the follower's path
};

/// Returns plainIdmAcceleration() (m/s2) with the gap clamped to at least `idm.min_gap`, as nuPlan
/// does. `speed`: the follower's, m/s.
inline double nuplanIdmAcceleration(const IdmParameters& idm, double speed, const IdmLead& lead) {
  return plainIdmAcceleration(idm, speed, lead.speed, std::max(lead.gap, idm.min_gap));
}

/// A follower on its path.
struct IdmState {
  double progress = 0.0;  ///< m along the path, of the caller's reference point on the vehicle
  double speed = 0.0;     ///< m/s along the path
};

/// Returns the state `duration` seconds later by one step of Euler's method: position at the
/// current speed, nuplanIdmAcceleration() behind `lead` clamped to [-b, a]. The speed may become
/// negative.
inline IdmState eulerStep(const IdmParameters& idm, const IdmState& state, const IdmLead& lead,
                          double duration) {
  const double acceleration =
      std::clamp(nuplanIdmAcceleration(idm, state.speed, lead), -idm.braking, idm.max_acceleration);
  return {state.progress + state.speed * duration, state.speed + acceleration * duration};
}

}  // namespace forge
