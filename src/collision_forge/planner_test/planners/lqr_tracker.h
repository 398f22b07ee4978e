#pragma once

#include <vector>

#include "collision_forge/planner_test/planners/kinematic_bicycle.h"

namespace forge {

/// Options of LqrTracker; values of nuPlan's LQRTracker.
struct LqrOptions {
  double step = 0.1;                  ///< s between the poses of a reference
  int horizon = 10;                   ///< steps that the controller optimises over
  double speed_weight = 10.0;         ///< of a squared error of speed (m/s), longitudinal Q
  double acceleration_weight = 1.0;   ///< of the squared acceleration (m/s2), longitudinal R
  double lateral_weight = 1.0;        ///< of a squared lateral error (m), lateral Q ...
  double heading_weight = 10.0;       ///< ... of a squared heading error (rad) ...
  double steering_weight = 0.0;       ///< ... of the squared steering angle (rad)
  double steering_rate_weight = 1.0;  ///< of the squared steering rate (rad/s), lateral R
  double stop_speed =
      0.2;  ///< m/s; below it, if the reference is too, speed alone is controlled ...
  double stop_gain = 0.5;                ///< 1/s ... proportionally
  double jerk_penalty = 0.0001;          ///< of the squared jerk (m/s3) in the fit of speeds
  double curvature_rate_penalty = 0.01;  ///< of the squared curvature rate (1/(m s)) in its fit
};

/// Quantity that the fit of the speeds penalises.
enum class SpeedFit {
  kJerk,         ///< as nuPlan's LQRTracker
  kAcceleration  ///< as PDM-Closed: every acceleration but the last, and the last one's change
};

/// Speed and curvature along a sequence of poses, one value between each two consecutive poses.
struct ReferenceProfile {
  std::vector<double> speeds;      ///< m/s
  std::vector<double> curvatures;  ///< 1/m
};

/// Fits speeds and curvatures to poses (every `options.step` seconds) by regularised least squares.
/// Speeds are penalised with `options.jerk_penalty` by `fit`, curvatures with
/// `options.curvature_rate_penalty`. Throws std::invalid_argument for fewer than two poses.
ReferenceProfile fitProfile(const std::vector<Pose2>& poses, const LqrOptions& options,
                            SpeedFit fit = SpeedFit::kJerk);

/// Controller that drives a KinematicBicycle along a reference, after nuPlan's LQRTracker: first
/// the best constant acceleration over the horizon, then the best constant steering rate, for the
/// motion linearised about the reference.
class LqrTracker {
 public:
  /// `wheelbase`: m.
  LqrTracker(const LqrOptions& options, double wheelbase, SpeedFit fit = SpeedFit::kJerk);

  /// Sets the reference: poses of the rear axle, one every `options.step` seconds; index 0 is the
  /// first. Throws std::invalid_argument for fewer than two poses.
  void setReference(std::vector<Pose2> rear_axle_poses);

  /// Returns the command at the time of reference `index` (clamped to the last).
  BicycleCommand command(const BicycleState& state, std::size_t index) const;

  /// Speeds and curvatures fitted to the reference.
  const ReferenceProfile& profile() const { return profile_; }

 private:
  double acceleration(double speed, double reference_speed) const;
  double steeringRate(const BicycleState& state, double acceleration, std::size_t index) const;

  LqrOptions options_;
  double wheelbase_;
  SpeedFit fit_;
  std::vector<Pose2> poses_;
  ReferenceProfile profile_;
};

}  // namespace forge
