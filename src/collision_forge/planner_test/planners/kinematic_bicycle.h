#pragma once

#include "collision_forge/base/geometry/pose2.h"
#include "collision_forge/base/scene/attack.h"

namespace forge {

/// Options of KinematicBicycle: config/planners.yaml, section car, where each number's source
/// stands; the limits of acceleration and braking come from config/vehicle_limits.yaml.
struct KinematicBicycleOptions {
  double wheelbase = 0.0;         ///< m between the axles
  double max_steering = 0.0;      ///< rad, of the front wheel to either side
  double max_acceleration = 0.0;  ///< m/s2
  double max_braking = 0.0;       ///< m/s2, positive
  double acceleration_lag = 0.0;  ///< s, time constant of the acceleration
  double steering_lag = 0.0;      ///< s, time constant of the steering angle
};

/// State of the bicycle model; pose in the global map frame.
struct BicycleState {
  Pose2 rear_axle;            ///< middle of the rear axle, yaw along the vehicle
  double speed = 0.0;         ///< m/s along the heading, negative backwards
  double acceleration = 0.0;  ///< m/s2 along the heading
  double steering = 0.0;      ///< rad, angle of the front wheel, positive to the left
};

/// Input of the bicycle model, held over one step.
struct BicycleCommand {
  double acceleration = 0.0;   ///< m/s2 along the heading, negative brakes
  double steering_rate = 0.0;  ///< rad/s, positive to the left
};

/// Kinematic bicycle model without slip, as nuPlan's KinematicBicycleModel: acceleration and
/// steering angle follow the command with first-order lags (x + d / (d + lag) (command - x) after a
/// step of d seconds); speed advances with the new acceleration, the pose with the speed and
/// steering at the start of the step. The commanded acceleration and the resulting steering angle
/// are clamped to the limits, the speed is not. Continued braking at standstill makes the car roll
/// back.
class KinematicBicycle {
 public:
  explicit KinematicBicycle(const KinematicBicycleOptions& options) : options_(options) {}

  /// Returns the state `duration` seconds (> 0) later, yaw in (-pi, pi].
  BicycleState step(const BicycleState& state, const BicycleCommand& command,
                    double duration) const;

  /// Returns the curvature of the rear axle's path for the state's steering angle, 1/m, positive to
  /// the left.
  double curvature(const BicycleState& state) const;

  /// Converts a trajectory point (middle of the box) to a bicycle state; the steering angle is
  /// clamped to its limit. `point.curvature` must be yaw rate over speed, as pointOf() returns it.
  /// `center_offset`: m from the rear axle to the middle of the box, as in EgoVehicle.
  BicycleState stateOf(const TrajectoryPoint& point, double center_offset) const;

  /// Converts a bicycle state to a trajectory point (middle of the box) at `time` (s).
  /// `center_offset` as in stateOf(). The curvature of the point is curvature().
  TrajectoryPoint pointOf(const BicycleState& state, double time, double center_offset) const;

 private:
  KinematicBicycleOptions options_;
};

/// Returns the pose of the rear axle, `center_offset` metres behind the middle of the box, in the
/// frame of `box_middle`.
Pose2 rearAxleOf(const Pose2& box_middle, double center_offset);

/// Returns the pose of the middle of the box, `center_offset` metres ahead of the rear axle, in the
/// frame of `rear_axle`.
Pose2 boxMiddleOf(const Pose2& rear_axle, double center_offset);

}  // namespace forge
