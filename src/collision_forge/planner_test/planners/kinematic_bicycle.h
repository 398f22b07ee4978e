#pragma once

#include "collision_forge/base/geometry/pose2.h"
#include "collision_forge/base/scene/attack.h"

namespace forge {

/// config/planners.yaml, section car, where each number's unit and source stand; the greatest
/// acceleration and braking are those of config/vehicle_limits.yaml.
struct KinematicBicycleOptions {
  double wheelbase = 0.0;
  double max_steering = 0.0;
  double max_acceleration = 0.0;
  double max_braking = 0.0;
  double acceleration_lag = 0.0;
  double steering_lag = 0.0;
};

/// Global map frame.
struct BicycleState {
  Pose2 rear_axle;
  double speed = 0.0;         ///< m/s along the heading
  double acceleration = 0.0;  ///< m/s2 along the heading
  double steering = 0.0;      ///< rad, angle of the front wheel, positive to the left
};

struct BicycleCommand {
  double acceleration = 0.0;   ///< m/s2
  double steering_rate = 0.0;  ///< rad/s
};

/// A car as a kinematic bicycle without slip, as nuPlan's KinematicBicycleModel: acceleration and
/// steering follow the command with first-order lags, the pose moves with the state before the
/// step. What is asked for stays within the limits. A car that is braked on at a standstill rolls
/// back.
class KinematicBicycle {
 public:
  explicit KinematicBicycle(const KinematicBicycleOptions& options) : options_(options) {}

  /// `duration` seconds (> 0) later.
  BicycleState step(const BicycleState& state, const BicycleCommand& command,
                    double duration) const;

  /// Of the rear axle's way, 1/m, positive to the left.
  double curvature(const BicycleState& state) const;

  /// The car at a point of its motion. The point's curvature is yaw rate over speed, as in
  /// pointOf().
  BicycleState stateOf(const TrajectoryPoint& point, double center_offset) const;

  /// `center_offset` as in EgoVehicle.
  TrajectoryPoint pointOf(const BicycleState& state, double time, double center_offset) const;

 private:
  KinematicBicycleOptions options_;
};

/// The rear axle of a box whose middle is `center_offset` metres ahead of it.
Pose2 rearAxleOf(const Pose2& box_middle, double center_offset);

/// The middle of the box, `center_offset` metres ahead of the rear axle.
Pose2 boxMiddleOf(const Pose2& rear_axle, double center_offset);

}  // namespace forge
