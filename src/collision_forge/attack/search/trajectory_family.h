#pragma once

#include <array>
#include <optional>
#include <vector>

#include "collision_forge/attack/forecast/motion_estimate.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/base/scene/attack.h"

namespace forge {

/// Target state of a motion.
struct Arrival {
  double time = 0.0;                ///< s after t0; must be positive; the motion need not end there
  Pose2 pose;                       ///< box centre, global map frame
  double speed = 0.0;               ///< m/s along the heading
  double start_acceleration = 0.0;  ///< m/s2 along the heading at t0
  double end_acceleration = 0.0;    ///< m/s2 along the heading at the arrival
};

/// Start and sampling, common to all motions of one attacker in one search.
struct DriveStart {
  Motion motion;      ///< of the attacker at t0, box centre
  double now = 0.0;   ///< s, t0 on the scene clock
  double step = 0.0;  ///< s between points
  int points = 0;     ///< number of points, the first at t0
};

/// Drives a quintic polynomial on each axis of the map from the start to the arrival, and straight
/// on from there (Werling et al. 2010, "Optimal trajectory generation for dynamic street scenarios
/// in a Frenet frame"). Overwrites `points` with DriveStart::points points; the motion may break
/// the limits. Throws std::invalid_argument if arrival.time is not positive.
void driveQuintic(const DriveStart& start, const Arrival& arrival,
                  std::vector<TrajectoryPoint>& points);

/// Input of the bicycle: values at kCount instants evenly spaced from t0 to the end of the
/// steering, linear in between.
struct SteeringKnots {
  static constexpr int kCount = 5;            ///< knots per control
  std::array<double, kCount> acceleration{};  ///< m/s2 along the heading
  std::array<double, kCount> curvature{};     ///< 1/m, positive to the left
};

/// A kinematic bicycle steered by knots of acceleration and curvature, clamped to the limits at
/// every step. Unlike a quintic it can turn from rest and combine hard braking and turning.
class BicycleFamily {
 public:
  /// m between arrival and reached position that solve() accepts
  static constexpr double kMaxMiss = 1.0;

  explicit BicycleFamily(const VehicleLimits& limits) : limits_(limits) {}

  /// Returns knots that bring the bicycle to the arrival at its time, by damped least squares
  /// (Levenberg 1944, Marquardt 1963); empty if it stays more than kMaxMiss away. Heading and speed
  /// are matched as well as possible; accelerations of the arrival are ignored.
  std::optional<SteeringKnots> solve(const DriveStart& start, const Arrival& arrival) const;

  /// Overwrites `points` (box centres, map frame) with DriveStart::points points: steers by `knots`
  /// for `duration` s from t0, then goes straight at constant speed.
  void roll(const DriveStart& start, const SteeringKnots& knots, double duration,
            std::vector<TrajectoryPoint>& points) const;

 private:
  VehicleLimits limits_;
};

}  // namespace forge
