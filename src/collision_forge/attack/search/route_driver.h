#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "collision_forge/attack/search/speed_variation.h"
#include "collision_forge/attack/search/track_driver.h"
#include "collision_forge/base/map/reference_path.h"

namespace forge {

/// Largest accelerations that a driver uses until its manoeuvre; all values are magnitudes.
struct DrivingStyle {
  double forward = 0.0;  ///< m/s2, acceleration
  double braking = 0.0;  ///< m/s2, deceleration
  double lateral = 0.0;  ///< m/s2, in bends
  double jerk = 0.0;     ///< m/s3
  double cost = 0.0;     ///< added to Attack::effort, as a share of the futures
};

/// Styles, calmest first: a driver takes the first one with which it arrives in time. The first
/// three were chosen so that a classifier can hardly separate attackers from recorded vehicles
/// (docs/results.md); the last one is for emergencies.
inline constexpr std::array<DrivingStyle, 4> kDrivingStyles{{{0.4, 1.0, 2.0, 0.5, 0.0},
                                                             {1.0, 1.0, 2.0, 1.0, 0.06},
                                                             {2.0, 2.5, 2.8, 3.0, 0.14},
                                                             {4.0, 6.0, 4.0, 10.0, 0.3}}};

/// m; largest distance from a route to the ego at the contact
inline constexpr double kRouteReach = 7.0;
inline constexpr double kArrivalPrecision = 0.3;  ///< m along the route that an arrival may miss
/// m; largest distance from the lane's middle in a manoeuvre
inline constexpr double kMaxDeparture = 5.0;
/// rad; largest angle between vehicle and lane at the contact
inline constexpr double kMaxLean = 0.6;
/// rad; arrivals are chosen this far inside both ends of the type's heading band.
inline constexpr double kArrivalHeadingMargin = 0.03;
/// m from the middle of the lane within which a vehicle may stand that pulls out; parked cars are 2
/// to 4 m away.
inline constexpr double kParkingDistance = 4.5;

/// Task of a driver on its route. All times in s; places along the route are in m from its start. A
/// plan needs arrival > 0 and is meant for 0 <= lead < departure <= arrival. A longer departure
/// begins at t0 (of a standing vehicle: after `wait`); a lateral motion shorter than one time step,
/// as for departure = lead = 0, takes one step.
struct RoutePlan {
  double arrival = 0.0;    ///< s after t0 at which the box centre is at `at`
  PathPose at;             ///< pose of the box centre relative to the route at the arrival
  double departure = 0.0;  ///< s before the arrival at which the vehicle starts to leave its lane
  /// s before the arrival at which the lateral motion ends; from there the vehicle drives straight
  /// at the angle at.lean to the route, to at.across at the arrival.
  double lead = 0.0;
  double late = 0.0;  ///< s before the arrival at which `late_acceleration` begins; 0: never
  /// m/s2 along the route, from `late` before the arrival to the arrival; negative: brakes
  double late_acceleration = 0.0;
  double wait = 0.0;  ///< s after t0 until which a vehicle that stands waits
};

/// Driving style and speed along a route.
struct RouteSpeed {
  std::size_t style = 0;  ///< index into kDrivingStyles, calmest first
  double speed = 0.0;     ///< m/s that the driver aims at; slower in bends
};

/// Cache of the distances (m along the route) at the arrival, per index of kDrivingStyles by the
/// chosen speed (m/s). Known speeds bracket the search for the next one. Start with an empty one.
struct RouteReach {
  /// per style: chosen speed -> distance at the arrival
  std::vector<std::map<double, double>> styles;
};

/// Longitudinal motion along a route.
struct RouteCourse {
  /// m along the route of the box centre, one per step from t0 to before the arrival
  std::vector<double> alongs;
  std::vector<ReferencePath::PathPoint> places;  ///< points of the route at `alongs`
  double end = 0.0;                              ///< m along the route at the arrival
};

/// Model of a driver on a route: keeps its lateral offset, drives at one chosen speed, slower in
/// bends and with a small variation, and leaves the lane only for the contact. Immutable.
class RouteDriver {
 public:
  /// `now`: the vehicle's state at t0; `limits`: the limits of its class, used up to kLimitShare;
  /// `variation`: of its speed. Computes the speeds that bends allow for each style.
  RouteDriver(ReferencePath path, const DriveState& now, const DriveLimits& limits,
              const SpeedVariation& variation = {});

  /// Returns the route.
  const ReferencePath& path() const { return path_; }
  /// Returns the pose of the vehicle's box centre on the route at t0.
  const PathPose& start() const { return start_; }
  /// Returns the lateral offset (m, left) at `along` (m) of a vehicle that keeps its lane: decays
  /// from the offset and heading (at most kMaxLean) at t0 to 0, critically damped with the decay
  /// length of 80 m: after 80 m, 74 % of the offset of a vehicle parallel to the lane are left.
  /// Before start(), the offset at t0.
  double keptOffset(double along) const;

  /// Returns the calmest style and its speed that reach wanted.at.along at the arrival (to
  /// kArrivalPrecision), at time step `step` (s); empty if none does. Depends only on the plan's
  /// times, at.along and late_acceleration. `reach` caches results and must be shared only by plans
  /// with equal arrival, late, late_acceleration and wait.
  std::optional<RouteSpeed> speedFor(const RoutePlan& wanted, double step, RouteReach& reach) const;

  /// Returns the motion from t0 at `speed`, one place per `step` (s); depends only on the plan's
  /// arrival, late, late_acceleration and wait.
  RouteCourse courseAt(const RoutePlan& wanted, const RouteSpeed& speed, double step) const;

  /// Overwrites `planned` with `steps` steps every `step` s from t0: along `course` (courseAt() of
  /// the same plan and step) with the plan's lateral motion (keptOffset() until the departure, then
  /// a quintic), straight on at the last speed after the arrival.
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
  std::vector<std::vector<float>> caps_;  // m/s in bends, [style][m along]
};

}  // namespace forge
