#pragma once

#include <vector>

#include "attack/attack.h"
#include "attack/motion_estimate.h"
#include "attack/options.h"
#include "map/reference_path.h"

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

/// A way of driving from now to an arrival and straight on from there. Implementations are
/// immutable. `points` is overwritten. False when the family has no such motion; a motion may still
/// break the limits.
class TrajectoryFamily {
 public:
  virtual ~TrajectoryFamily() = default;
  virtual bool drive(const DriveStart& start, const Arrival& arrival,
                     std::vector<TrajectoryPoint>& points) const = 0;
};

/// A quintic polynomial on each axis, of the map or, with a reference path, along and across that
/// path (Werling et al. 2010, "Optimal trajectory generation for dynamic street scenarios in a
/// Frenet frame"): with it the attacker keeps to its lane as far as the arrival allows.
class QuinticFamily : public TrajectoryFamily {
 public:
  QuinticFamily() = default;
  /// The path must outlive the family.
  explicit QuinticFamily(const ReferencePath& path) : path_(&path) {}
  bool drive(const DriveStart& start, const Arrival& arrival,
             std::vector<TrajectoryPoint>& points) const override;

 private:
  const ReferencePath* path_ = nullptr;
};

/// A kinematic bicycle steered by five knots of acceleration and five of curvature, linear in
/// between, held to the limits at every step; the knots are found by damped least squares on the
/// arrival (Levenberg 1944, Marquardt 1963). Can turn from rest, brake and turn hard: what a
/// quintic cannot. Its own start and end acceleration are used; the arrival's are not.
class BicycleFamily : public TrajectoryFamily {
 public:
  BicycleFamily(const VehicleLimits& limits, const BicycleOptions& options)
      : limits_(limits), options_(options) {}
  bool drive(const DriveStart& start, const Arrival& arrival,
             std::vector<TrajectoryPoint>& points) const override;

 private:
  VehicleLimits limits_;
  BicycleOptions options_;
};

}  // namespace forge
