#pragma once

#include <optional>
#include <vector>

#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/search/speed_variation.h"
#include "collision_forge/attack/search/track_driver.h"
#include "collision_forge/base/map/reference_path.h"

namespace forge {

/// Task of a driver on its route. All times in s.
struct RoutePlan {
  double arrival = 0.0;            ///< s after t0
  PathPose at;                     ///< pose on the route at the arrival
  double departure = 0.0;          ///< s before arrival: starts to leave its lane
  double lead = 0.0;               ///< s before arrival: has reached its lateral position
  double late = 0.0;               ///< s before arrival: late_acceleration begins; 0: never
  double late_acceleration = 0.0;  ///< m/s2
  double wait = 0.0;               ///< s after t0 for which a standing vehicle waits
};

/// Driving style and speed along a route.
struct RouteSpeed {
  std::size_t style = 0;  ///< index into the styles, gentlest first
  double speed = 0.0;     ///< m/s, chosen speed
};

/// Cache of the distance (m along the route) that each style reaches at lowest and highest speed;
/// empty entries are not computed yet.
struct RouteReach {
  std::vector<std::optional<double>> slowest;
  std::vector<std::optional<double>> fastest;
};

/// Longitudinal motion along a route.
struct RouteCourse {
  std::vector<double> alongs;                ///< m along, one per step until the arrival
  std::vector<ReferencePath::Place> places;  ///< at `alongs`
  double end = 0.0;                          ///< m along at the arrival
};

/// Model of a driver on a route: keeps its lateral offset, drives at one chosen speed, slower in
/// bends and with a small variation, and leaves the lane only for the contact. Immutable.
class RouteDriver {
 public:
  /// `now`: the vehicle's state at t0; `limits`: its vehicle's. `options` must outlive this object.
  RouteDriver(ReferencePath path, const DriveState& now, const DriveLimits& limits,
              const RouteDriverOptions& options, const SpeedVariation& variation = {});

  const ReferencePath& path() const { return path_; }
  const PathPose& start() const { return start_; }
  /// Returns the lateral offset (m, left) at `along` (m): decays from the offset and heading at t0
  /// to 0.
  double keptOffset(double along) const;

  /// Returns the gentlest style and its speed that reach wanted.at.along at the arrival, at time
  /// step `step` (s); empty if none does. Depends only on the plan's times, at.along and
  /// late_acceleration. `reach` caches results and must be shared only by plans with equal arrival,
  /// late, late_acceleration and wait.
  std::optional<RouteSpeed> speedFor(const RoutePlan& wanted, double step, RouteReach& reach) const;

  /// Returns the motion at `speed`; depends only on the plan's arrival, late, late_acceleration and
  /// wait.
  RouteCourse courseAt(const RoutePlan& wanted, const RouteSpeed& speed, double step) const;

  /// Overwrites `planned` with `steps` steps every `step` s from t0: along the course with the
  /// plan's lateral motion, straight on after the arrival.
  void plan(const RoutePlan& wanted, const RouteCourse& course, double step, std::size_t steps,
            std::vector<PlannedStep>& planned) const;

 private:
  struct Cruise;
  Cruise cruiseOf(const RoutePlan& wanted, const RouteSpeed& speed, double step) const;
  double drive(const Cruise& cruise, std::vector<double>* alongs) const;
  double cap(std::size_t style, double along) const;

  ReferencePath path_;
  const RouteDriverOptions& options_;
  DriveLimits limits_;
  DriveState now_;
  PathPose start_;
  SpeedVariation variation_;
  std::vector<std::vector<float>> caps_;  // m/s in bends, [style][m along]
};

}  // namespace forge
