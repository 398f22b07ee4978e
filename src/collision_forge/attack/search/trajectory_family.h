#pragma once

#include <array>
#include <optional>
#include <vector>

#include "collision_forge/attack/forecast/motion_estimate.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/base/scene/attack.h"

namespace forge {

/// Where and how the attacker is to arrive.
struct Arrival {
  double time = 0.0;                ///< s from now, > 0
  Pose2 pose;                       ///< box middle, global map frame
  double speed = 0.0;               ///< m/s along the heading
  double start_acceleration = 0.0;  ///< m/s2 along the heading, now
  double end_acceleration = 0.0;    ///< m/s2 along the heading, at the arrival
};

/// What all motions of one attacker in one search share.
struct DriveStart {
  Motion motion;      ///< the attacker's, now
  double now = 0.0;   ///< s, the snapshot's clock
  double step = 0.0;  ///< s between points
  int points = 0;     ///< how many, the first at now
};

/// Drives a quintic polynomial on each axis of the map from the start to the arrival, and straight
/// on from there (Werling et al. 2010, "Optimal trajectory generation for dynamic street scenarios
/// in a Frenet frame"). Overwrites `points` with DriveStart::points points; the motion may break
/// the limits.
void driveQuintic(const DriveStart& start, const Arrival& arrival,
                  std::vector<TrajectoryPoint>& points);

/// What steers the bicycle: values at instants evenly spread from now to the end of the steering,
/// linear in between. Acceleration along the heading in m/s2, curvature in 1/m.
struct SteeringKnots {
  static constexpr int kCount = 5;
  std::array<double, kCount> acceleration{};
  std::array<double, kCount> curvature{};
};

/// A kinematic bicycle steered by knots of acceleration and curvature, held to the limits at every
/// step. Can turn from rest, brake and turn hard: what a quintic cannot.
class BicycleFamily {
 public:
  static constexpr double kMaxMiss = 1.0;  ///< m between arrival and reached position

  explicit BicycleFamily(const VehicleLimits& limits) : limits_(limits) {}

  /// Knots that bring the bicycle to the arrival, found by damped least squares (Levenberg 1944,
  /// Marquardt 1963); empty when it stays further than kMaxMiss away.
  std::optional<SteeringKnots> solve(const DriveStart& start, const Arrival& arrival) const;

  /// Steers for `duration` seconds, then goes straight on.
  void roll(const DriveStart& start, const SteeringKnots& knots, double duration,
            std::vector<TrajectoryPoint>& points) const;

 private:
  VehicleLimits limits_;
};

}  // namespace forge
