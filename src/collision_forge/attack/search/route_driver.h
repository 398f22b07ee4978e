#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "collision_forge/attack/search/speed_variation.h"
#include "collision_forge/attack/search/track_driver.h"
#include "collision_forge/base/map/reference_path.h"

namespace forge {

/// How hard a driver drives until its manoeuvre.
struct DrivingStyle {
  double forward = 0.0;  ///< m/s2
  double braking = 0.0;  ///< m/s2
  double lateral = 0.0;  ///< m/s2, in bends
  double jerk = 0.0;     ///< m/s3
  double cost = 0.0;     ///< share of the futures
};

/// The calmest first: a driver takes the first style that arrives in time. The first three were
/// chosen so that a classifier can hardly tell attackers from recorded vehicles (docs/results.md);
/// the last one is for drivers in trouble.
inline constexpr std::array<DrivingStyle, 4> kDrivingStyles{{{0.4, 1.0, 2.0, 0.5, 0.0},
                                                             {1.0, 1.0, 2.0, 1.0, 0.06},
                                                             {2.0, 2.5, 2.8, 3.0, 0.14},
                                                             {4.0, 6.0, 4.0, 10.0, 0.3}}};

inline constexpr double kRouteReach = 7.0;        ///< m from a route to the ego, at most
inline constexpr double kArrivalPrecision = 0.3;  ///< m along the route that an arrival may miss
inline constexpr double kMaxDeparture = 5.0;      ///< m from the lane's middle in a manoeuvre
inline constexpr double kMaxLean = 0.6;           ///< rad between vehicle and lane at the contact
/// rad kept to either end of the band of headings of the type when an arrival is chosen.
inline constexpr double kArrivalHeadingMargin = 0.03;
/// m from the lane's middle that a vehicle may stand that pulls out; parked cars are 2 to 4 m away.
inline constexpr double kParkingDistance = 4.5;

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
  std::size_t style = 0;  ///< of kDrivingStyles
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
              const SpeedVariation& variation = {});

  const ReferencePath& path() const { return path_; }
  const PathPose& start() const { return start_; }
  /// The offset that the driver keeps, at a place along the path: it goes on as it leans now, and
  /// comes back to the middle.
  double keptOffset(double along) const;

  /// How the driver gets to the plan's place along the path in time, by the tamest of
  /// kDrivingStyles that does, in steps of `step` seconds. Empty where none does. Tells
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
  DriveLimits limits_;
  DriveState now_;
  PathPose start_;
  SpeedVariation variation_;
  std::vector<std::vector<float>> caps_;  // m/s in bends, one row a style, an entry a metre
};

}  // namespace forge
