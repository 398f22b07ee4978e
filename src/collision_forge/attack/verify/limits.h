#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_forge/attack/verify/options.h"
#include "collision_forge/base/scene/attack.h"

namespace forge {

/// A limit that a trajectory violates; value and limit have the unit of the key `name`.
struct BrokenLimit {
  /// Key in config/vehicle_limits.yaml, or "finite", "no_reversing", "speed_of_positions", or a
  /// name of findBrokenDrive(). A string literal.
  const char* name = "";
  double value = 0.0;  ///< value of the trajectory; 0 for "finite"
  double limit = 0.0;  ///< largest allowed value; 0 for "finite"
};

/// Keeps the violated limit with the greatest ratio of value to limit.
class WorstLimit {
 public:
  /// Records `value` if it exceeds `limit` by a greater ratio than every value so far; above a
  /// limit of 0 the ratio is 1 + value. `name` must be a string literal.
  void check(const char* name, double value, double limit) {
    if (value <= limit) return;
    const double ratio = limit > 0.0 ? value / limit : 1.0 + value;
    if (found_ && ratio <= ratio_) return;
    ratio_ = ratio;
    found_ = BrokenLimit{name, value, limit};
  }
  /// Returns the worst violation so far; empty if there is none.
  const std::optional<BrokenLimit>& found() const { return found_; }

 private:
  double ratio_ = 0.0;
  std::optional<BrokenLimit> found_;
};

/// Checks the stored values of each point up to and including the first at or after `until` (s,
/// clock of the points), all if none is: forward, braking and total acceleration (lateral part
/// speed^2 * curvature), speed, no reversing, curvature. Below limits.curvature_min_speed curvature
/// is ill-defined; there the heading may change by heading_slack + heading_per_metre * distance
/// since the slow stretch began ("heading_slack"). The same limit holds between `start_yaw` (rad,
/// recorded yaw at t0) and the first point. Returns the violation with the greatest ratio of value
/// to limit, empty if there is none.
std::optional<BrokenLimit> findBrokenLimit(const std::vector<TrajectoryPoint>& points,
                                           double start_yaw, double until,
                                           const VehicleLimits& limits);

/// Checks the positions of the points before `until` (s, clock of the points), except the first and
/// the last point of all: total acceleration as second difference of positions and its part along
/// the heading, at most 0.05 m/s2 above the limits; and the stored |speed| within 0.3 m/s of the
/// speeds of the steps before and after the point, or between them ("speed_of_positions"). Returns
/// the violation with the greatest ratio of value to limit, empty if there is none. Values must be
/// finite and times must increase.
std::optional<BrokenLimit> findBrokenPositions(const std::vector<TrajectoryPoint>& points,
                                               double until, const VehicleLimits& limits);

/// Returns true if findBrokenLimit() and findBrokenPositions() find no violation; faster than both,
/// because it stops at the first one.
bool keepsLimits(const std::vector<TrajectoryPoint>& points, double start_yaw, double until,
                 const VehicleLimits& limits);

/// Returns "name value > limit" with three decimals, for example "max_braking 8.512 > 8.000".
std::string describe(const BrokenLimit& broken);

/// Returns the mean over the points up to and including the first at or after `until` (s, clock of
/// the points) of (total acceleration / limits.max_total_acceleration)^2: 0 for constant velocity
/// or no points, 1 for driving at the limit throughout.
double effort(const std::vector<TrajectoryPoint>& points, double until,
              const VehicleLimits& limits);

/// Returns the greatest |rate of curvature|, 1/(m s), between neighbouring points that both move at
/// limits.curvature_min_speed or faster, up to the first point at or after `until` (s, clock of the
/// points); 0 if there is no such pair.
double fastestSteering(const std::vector<TrajectoryPoint>& points, double until,
                       const VehicleLimits& limits);

}  // namespace forge
