#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_forge/attack/verify/options.h"
#include "collision_forge/base/scene/attack.h"

namespace forge {

/// A limit that a trajectory breaks, and by how much.
struct BrokenLimit {
  /// Key in config/vehicle_limits.yaml, or "no_reversing", "finite", "speed_of_positions".
  const char* name = "";
  double value = 0.0;
  double limit = 0.0;
};

/// Keeps the broken limit with the greatest ratio of value to limit.
class WorstLimit {
 public:
  void check(const char* name, double value, double limit) {
    if (value <= limit) return;
    const double ratio = limit > 0.0 ? value / limit : 1.0 + value;
    if (found_ && ratio <= ratio_) return;
    ratio_ = ratio;
    found_ = BrokenLimit{name, value, limit};
  }
  const std::optional<BrokenLimit>& found() const { return found_; }

 private:
  double ratio_ = 0.0;
  std::optional<BrokenLimit> found_;
};

/// Checks every point up to and including the first at or after `until`: acceleration forward,
/// braking and in total (speed^2 * curvature across), speed, no reversing, and curvature. Below
/// `curvature_min_speed` curvature is not defined well; there the heading may change, from where
/// the slow stretch began, by heading_slack + heading_per_metre * distance. The same holds between
/// `start_yaw` (the recorded yaw now) and the first point. Returns the worst broken limit, by
/// ratio.
std::optional<BrokenLimit> findBrokenLimit(const std::vector<TrajectoryPoint>& points,
                                           double start_yaw, double until,
                                           const VehicleLimits& limits);

/// Holds what the positions alone say of the points before `until` against what is written and
/// allowed: the total acceleration as a second difference of positions, and forwards and backwards
/// its part along the heading (a reader of the points finds no more than 0.05 m/s2 above the
/// limits), and the written speeds, without sign, as those of
/// the steps before and after each point ("speed_of_positions": within 0.3 m/s of either or between
/// the two). Returns the worst, by ratio. Points are finite (findBrokenLimit() tells) and their
/// times increase.
std::optional<BrokenLimit> findBrokenPositions(const std::vector<TrajectoryPoint>& points,
                                               double until, const VehicleLimits& limits);

/// Neither findBrokenLimit() nor findBrokenPositions() finds anything; quicker than both.
bool keepsLimits(const std::vector<TrajectoryPoint>& points, double start_yaw, double until,
                 const VehicleLimits& limits);

/// "name value > limit", for people.
std::string describe(const BrokenLimit& broken);

/// Mean square over the points until then of the total acceleration over its limit: 0 for a
/// constant velocity, 1 for driving at the limit throughout.
double effort(const std::vector<TrajectoryPoint>& points, double until,
              const VehicleLimits& limits);

/// Fastest change of curvature, 1/(m s), between neighbours that both drive at curvature_min_speed
/// or faster, of the points up to and including the first at or after `until`.
double fastestSteering(const std::vector<TrajectoryPoint>& points, double until,
                       const VehicleLimits& limits);

}  // namespace forge
