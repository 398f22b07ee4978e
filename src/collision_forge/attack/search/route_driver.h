#pragma once

#include <map>
#include <optional>
#include <vector>

#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/search/speed_variation.h"
#include "collision_forge/attack/search/track_driver.h"
#include "collision_forge/base/map/reference_path.h"

namespace forge {

/// What a driver is to do on its route.
struct RoutePlan {
  double arrival = 0.0;            ///< s from now
  PathPose at;                     ///< at the arrival
  double departure = 0.0;          ///< s before the arrival that it begins to leave its lane
  double lead = 0.0;               ///< s before the arrival that it is where it will arrive, across
  double late = 0.0;               ///< s before the arrival that late_acceleration begins, 0: never
  double late_acceleration = 0.0;  ///< m/s2
  double wait = 0.0;               ///< s from now that one who stands now waits
};

/// How a driver comes along its route.
struct RouteSpeed {
  std::size_t style = 0;  ///< of RouteDriverOptions::styles
  double speed = 0.0;     ///< m/s that it chooses
};

/// The distance along a route that each style drives until the arrival, m, by the speed that the
/// driver chooses, m/s: the speeds that were computed so far.
struct RouteReach {
  std::vector<std::map<double, double>> styles;
};

/// A drive along a route, without what happens across it.
struct RouteCourse {
  std::vector<double> alongs;                ///< m, a step each, until the arrival
  std::vector<ReferencePath::Place> places;  ///< there
  double end = 0.0;                          ///< m along, at the arrival
};

/// A driver who follows a route: keeps its offset from the route's middle, drives at a speed that
/// it chooses once, slower in bends and wandering a little, and leaves the lane only for what
/// happens at the arrival.
class RouteDriver {
 public:
  /// `now`: where the driver is; the limits are its vehicle's.
  RouteDriver(ReferencePath path, const DriveState& now, const DriveLimits& limits,
              const RouteDriverOptions& options, const SpeedVariation& variation = {});

  const ReferencePath& path() const { return path_; }
  const PathPose& start() const { return start_; }
  /// The offset that the driver keeps, at a place along the path: it goes on as it leans now, and
  /// comes back to the middle.
  double keptOffset(double along) const;

  /// How the driver gets to the plan's place along the path in time, by the tamest of
  /// RouteDriverOptions::styles that does, in steps of `step` seconds. Empty where none does. Tells
  /// the same for plans with the same times, place along and late acceleration. `reach` is what is
  /// known so far of plans with the same arrival, late, late_acceleration and wait.
  std::optional<RouteSpeed> speedFor(const RoutePlan& wanted, double step, RouteReach& reach) const;

  /// The drive at a speed, the same for plans with the same arrival, late, late_acceleration and
  /// wait.
  RouteCourse courseAt(const RoutePlan& wanted, const RouteSpeed& speed, double step) const;

  /// A step every `step` seconds from now on along the plan's course, straight on after the
  /// arrival.
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
  std::vector<std::vector<float>> caps_;  // m/s in bends, one row a style, an entry a metre
};

}  // namespace forge
