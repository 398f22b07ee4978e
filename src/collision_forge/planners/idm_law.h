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

/// Acceleration behind a lead at `lead_speed` m/s (along the follower's way) and `gap` metres
/// ahead, which must be positive: a (1 - (v/v0)^delta - (s*/gap)^2), s* = s0 + v T + v dv / (2
/// sqrt(a b)), not below zero where the lead gets away fast.
inline double idmAcceleration(const IdmParameters& idm, double speed, double lead_speed,
                              double gap) {
  const double closing = speed - lead_speed;
  const double desired_gap =
      idm.min_gap + speed * idm.time_headway +
      speed * closing / (2.0 * std::sqrt(idm.max_acceleration * idm.braking));
  const double share = std::max(desired_gap, 0.0) / gap;
  return idmFreeAcceleration(idm, speed) - idm.max_acceleration * share * share;
}

}  // namespace forge
