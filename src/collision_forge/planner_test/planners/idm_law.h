#pragma once

#include <algorithm>
#include <cmath>

namespace forge {

/// m; what callers give the law at least, instead of a gap that it cannot divide by.
inline constexpr double kTouchingGap = 0.01;

/// The intelligent driver model (Treiber, Hennecke, Helbing 2000, doi 10.1103/PhysRevE.62.1805).
struct IdmParameters {
  double desired_speed = 0.0;     ///< v0, m/s
  double time_headway = 0.0;      ///< T, s
  double max_acceleration = 0.0;  ///< a, m/s2
  double braking = 0.0;           ///< b, comfortable, m/s2, positive
  double min_gap = 0.0;           ///< s0, m
  double exponent = 0.0;          ///< delta
};

/// Acceleration on a free road, m/s2, at `speed` m/s.
inline double idmFreeAcceleration(const IdmParameters& idm, double speed) {
  return idm.max_acceleration * (1.0 - std::pow(speed / idm.desired_speed, idm.exponent));
}

/// s* = s0 + v T + v dv / (2 sqrt(a b)), m; negative behind a lead that gets away very fast.
inline double idmDesiredGap(const IdmParameters& idm, double speed, double lead_speed) {
  return idm.min_gap + speed * idm.time_headway +
         speed * (speed - lead_speed) / (2.0 * std::sqrt(idm.max_acceleration * idm.braking));
}

/// a (1 - (v/v0)^delta - (s*/gap)^2) behind a lead at `lead_speed` m/s (along the follower's way)
/// and `gap` metres ahead, not 0. A negative s* brakes as a positive one does.
inline double plainIdmAcceleration(const IdmParameters& idm, double speed, double lead_speed,
                                   double gap) {
  const double share = idmDesiredGap(idm, speed, lead_speed) / gap;
  return idmFreeAcceleration(idm, speed) - idm.max_acceleration * share * share;
}

/// The same with s* not below zero: a lead that gets away fast brakes nobody. `gap` is positive.
inline double idmAcceleration(const IdmParameters& idm, double speed, double lead_speed,
                              double gap) {
  const double share = std::max(idmDesiredGap(idm, speed, lead_speed), 0.0) / gap;
  return idmFreeAcceleration(idm, speed) - idm.max_acceleration * share * share;
}

/// A lead, seen from the follower.
struct IdmLead {
  double gap = 0.0;    ///< m, bumper to bumper
  double speed = 0.0;  ///< m/s along the follower's way
};

/// plainIdmAcceleration() as nuPlan uses it: no gap is less than the least one.
inline double nuplanIdmAcceleration(const IdmParameters& idm, double speed, const IdmLead& lead) {
  return plainIdmAcceleration(idm, speed, lead.speed, std::max(lead.gap, idm.min_gap));
}

/// A follower on its way.
struct IdmState {
  double progress = 0.0;  ///< m
  double speed = 0.0;     ///< m/s
};

/// `duration` seconds later by one step of Euler's method: on at the speed of now, and the
/// acceleration within [-b, a]. The speed may end below zero.
inline IdmState eulerStep(const IdmParameters& idm, const IdmState& state, const IdmLead& lead,
                          double duration) {
  const double acceleration =
      std::clamp(nuplanIdmAcceleration(idm, state.speed, lead), -idm.braking, idm.max_acceleration);
  return {state.progress + state.speed * duration, state.speed + acceleration * duration};
}

}  // namespace forge
