#pragma once

#include <vector>

#include "collision_forge/planner_test/planners/kinematic_bicycle.h"

namespace forge {

/// Options of LqrTracker; values of nuPlan's LQRTracker. Each weight and penalty is the factor of
/// the squared quantity that its comment names, in the cost that the controller or the fit
/// minimises.
struct LqrOptions {
  double step = 0.1;  ///< s between the poses of a reference
  int horizon = 10;   ///< steps that the controller optimises over; the reference speed is taken as
                      ///< many steps ahead, at most from the last piece
  double speed_weight = 10.0;         ///< of a squared error of speed (m/s), longitudinal Q
  double acceleration_weight = 1.0;   ///< of the squared acceleration (m/s2), longitudinal R
  double lateral_weight = 1.0;        ///< of a squared lateral error (m), lateral Q ...
  double heading_weight = 10.0;       ///< ... of a squared heading error (rad) ...
  double steering_weight = 0.0;       ///< ... of the squared steering angle (rad)
  double steering_rate_weight = 1.0;  ///< of the squared steering rate (rad/s), lateral R
  /// m/s; if the speed of the car and the reference speed are both at or below it, only the speed
  /// is controlled.
  double stop_speed = 0.2;
  /// 1/s; the acceleration is then stop_gain * (reference speed - speed), without steering.
  double stop_gain = 0.5;
  double jerk_penalty = 0.0001;          ///< of the squared jerk (m/s3) in the fit of speeds
  double curvature_rate_penalty = 0.01;  ///< of the squared curvature rate (1/(m s)) in its fit
};

/// Quantity that the fit of the speeds penalises.
enum class SpeedFit {
  kJerk,  ///< as nuPlan's LQRTracker
  /// As PDM-Closed: every acceleration but the last, and the last one's change.
  kAcceleration
};

/// Speed and curvature along a sequence of poses; element i is between pose i and pose i + 1.
struct ReferenceProfile {
  std::vector<double> speeds;      ///< m/s along the heading, negative backwards
  std::vector<double> curvatures;  ///< 1/m, positive to the left
};

/// Fits speeds and curvatures to poses (every `options.step` seconds) by regularised least squares.
/// Speeds are penalised with `options.jerk_penalty` by `fit`, curvatures with
/// `options.curvature_rate_penalty`. Throws std::invalid_argument for fewer than two poses.
ReferenceProfile fitProfile(const std::vector<Pose2>& poses, const LqrOptions& options,
                            SpeedFit fit = SpeedFit::kJerk);

/// Controller that drives a KinematicBicycle along a reference, after nuPlan's LQRTracker: first
/// the best constant acceleration over the horizon, then the best constant steering rate, for the
/// motion linearised about the reference. The cost counts the errors at the end of the horizon and
/// the constant input once.
class LqrTracker {
 public:
  /// `wheelbase`: m, of the controller's own model; may differ from the car's. `fit`: see
  /// fitProfile().
  LqrTracker(const LqrOptions& options, double wheelbase, SpeedFit fit = SpeedFit::kJerk);

  /// Sets the reference: poses of the rear axle in the global map frame, one every `options.step`
  /// seconds; index 0 is the first, where tracking starts. Throws std::invalid_argument for fewer
  /// than two poses.
  void setReference(std::vector<Pose2> rear_axle_poses);

  /// Returns the command (not clamped to limits of the car) for a car in `state` at the time of
  /// pose `index` of the reference; an index beyond the last pose counts as the last.
  /// setReference() must have been called.
  BicycleCommand command(const BicycleState& state, std::size_t index) const;

  /// Returns the speeds and curvatures fitted to the reference; empty before setReference().
  const ReferenceProfile& profile() const { return profile_; }

 private:
  /// Returns the constant acceleration (m/s2) over the horizon that minimises the cost of speed
  /// error and acceleration.
  double acceleration(double speed, double reference_speed) const;
  /// Returns the constant steering rate (rad/s) over the horizon that minimises the lateral cost,
  /// with the car at `acceleration` (m/s2). `index`: pose of the reference at the time of `state`.
  double steeringRate(const BicycleState& state, double acceleration, std::size_t index) const;

  LqrOptions options_;
  double wheelbase_;
  SpeedFit fit_;
  std::vector<Pose2> poses_;  ///< the reference, rear axle
  ReferenceProfile profile_;
};

}  // namespace forge
