#include "collision_forge/planner_test/planners/lqr_tracker.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace forge {
namespace {

constexpr double kCurvaturePenalty =
    1e-10;  // of the first curvature, undetermined for a car at rest

/// A symmetric matrix with two diagonals below the main one: first[i] is at (i, i - 1) and
/// second[i] at (i, i - 2).
struct BandedMatrix {
  explicit BandedMatrix(std::size_t size) : main(size), first(size), second(size) {}
  std::vector<double> main, first, second;
};

/// Solves matrix * x = right for a positive definite matrix (LDL^T).
std::vector<double> solve(BandedMatrix matrix, std::vector<double> right) {
  std::vector<double>& d = matrix.main;
  const std::size_t size = d.size();
  for (std::size_t i = 0; i < size; ++i) {
    if (i >= 2) {
      matrix.first[i] -= matrix.second[i] * matrix.first[i - 1];
      d[i] -= matrix.second[i] * matrix.second[i] / d[i - 2];
      matrix.second[i] /= d[i - 2];
      right[i] -= matrix.second[i] * right[i - 2];
    }
    if (i >= 1) {
      d[i] -= matrix.first[i] * matrix.first[i] / d[i - 1];
      matrix.first[i] /= d[i - 1];
      right[i] -= matrix.first[i] * right[i - 1];
    }
  }
  for (std::size_t i = size; i-- > 0;) {
    right[i] /= d[i];
    if (i + 1 < size) right[i] -= matrix.first[i + 1] * right[i + 1];
    if (i + 2 < size) right[i] -= matrix.second[i + 2] * right[i + 2];
  }
  return right;
}

void addJerk(BandedMatrix& matrix, std::size_t i, double penalty) {  // (v[i] - 2 v[i-1] + v[i-2])^2
  matrix.main[i] += penalty;
  matrix.main[i - 1] += 4.0 * penalty;
  matrix.main[i - 2] += penalty;
  matrix.first[i] -= 2.0 * penalty;
  matrix.first[i - 1] -= 2.0 * penalty;
  matrix.second[i] += penalty;
}

void addChange(BandedMatrix& matrix, std::size_t i, double penalty) {  // (v[i] - v[i-1])^2
  matrix.main[i] += penalty;
  matrix.main[i - 1] += penalty;
  matrix.first[i] -= penalty;
}

/// Returns the speeds v that minimise the sum of (v dt - moved)^2 plus the penalties.
std::vector<double> fitSpeeds(const std::vector<Pose2>& poses, const LqrOptions& options,
                              SpeedFit fit) {
  const double step = options.step;
  const std::size_t size = poses.size() - 1;
  BandedMatrix matrix(size);
  std::vector<double> right(size);
  for (std::size_t i = 0; i < size; ++i) {
    const Vector2 moved = poses[i + 1].position() - poses[i].position();
    matrix.main[i] = step * step;
    right[i] = step * moved.dot(poses[i].heading());
  }
  const double penalty = options.jerk_penalty / (step * step);
  for (std::size_t i = 2; i < size; ++i) {
    if (fit == SpeedFit::kJerk || i + 1 == size) {
      addJerk(matrix, i, penalty);
    } else {
      addChange(matrix, i - 1, penalty);
    }
  }
  return solve(std::move(matrix), std::move(right));
}

/// Returns the curvatures k that minimise the sum of (k v dt - turned)^2 + penalty * (change of k /
/// dt)^2.
std::vector<double> fitCurvatures(const std::vector<Pose2>& poses,
                                  const std::vector<double>& speeds, const LqrOptions& options) {
  const double step = options.step;
  const std::size_t size = poses.size() - 1;
  BandedMatrix matrix(size);
  std::vector<double> right(size);
  for (std::size_t i = 0; i < size; ++i) {
    const double driven = speeds[i] * step;
    matrix.main[i] = driven * driven;
    right[i] = driven * angleBetween(poses[i].yaw, poses[i + 1].yaw);
  }
  matrix.main[0] += kCurvaturePenalty;
  const double penalty = options.curvature_rate_penalty / (step * step);
  for (std::size_t i = 1; i < size; ++i) addChange(matrix, i, penalty);
  return solve(std::move(matrix), std::move(right));
}

/// Deviation of the car from its reference, or its change per rad/s of steering rate.
struct LateralState {
  double lateral = 0.0;   // m left of the reference
  double heading = 0.0;   // rad
  double steering = 0.0;  // rad
};

/// Propagates the deviation over `driven` metres by linear dynamics; `turned`: rad that the
/// reference turns by.
LateralState moved(const LateralState& state, double driven, double turned, double steered,
                   double wheelbase) {
  return {state.lateral + driven * state.heading,
          state.heading + driven * state.steering / wheelbase - turned, state.steering + steered};
}

}  // namespace

ReferenceProfile fitProfile(const std::vector<Pose2>& poses, const LqrOptions& options,
                            SpeedFit fit) {
  if (poses.size() < 2)
    throw std::invalid_argument("a reference trajectory needs at least two poses");
  ReferenceProfile profile;
  profile.speeds = fitSpeeds(poses, options, fit);
  profile.curvatures = fitCurvatures(poses, profile.speeds, options);
  return profile;
}

LqrTracker::LqrTracker(const LqrOptions& options, double wheelbase, SpeedFit fit)
    : options_(options), wheelbase_(wheelbase), fit_(fit) {}

void LqrTracker::setReference(std::vector<Pose2> rear_axle_poses) {
  profile_ = fitProfile(rear_axle_poses, options_, fit_);
  poses_ = std::move(rear_axle_poses);
}

BicycleCommand LqrTracker::command(const BicycleState& state, std::size_t index) const {
  const std::size_t last = profile_.speeds.size() - 1;
  const std::size_t ahead = std::min(index + static_cast<std::size_t>(options_.horizon), last);
  const double reference_speed = profile_.speeds[ahead];
  if (state.speed <= options_.stop_speed && reference_speed <= options_.stop_speed) {
    return {options_.stop_gain * (reference_speed - state.speed), 0.0};
  }
  BicycleCommand command;
  command.acceleration = acceleration(state.speed, reference_speed);
  command.steering_rate = steeringRate(state, command.acceleration, index);
  return command;
}

double LqrTracker::acceleration(double speed, double reference_speed) const {
  const double duration = options_.horizon * options_.step;
  const double gain = duration * options_.speed_weight /
                      (duration * duration * options_.speed_weight + options_.acceleration_weight);
  return gain * (reference_speed - speed);
}

double LqrTracker::steeringRate(const BicycleState& state, double acceleration,
                                std::size_t index) const {
  const Pose2 error = relativeTo(poses_[std::min(index, poses_.size() - 1)], state.rear_axle);
  LateralState free{error.y, error.yaw, state.steering};  // at the end, without steering
  LateralState gain;                                      // at the end, for each rad/s
  for (int i = 0; i < options_.horizon; ++i) {
    const double speed = state.speed + acceleration * options_.step * i;
    const double driven = speed * options_.step;
    const std::size_t at =
        std::min(index + static_cast<std::size_t>(i), profile_.curvatures.size() - 1);
    free = moved(free, driven, driven * profile_.curvatures[at], 0.0, wheelbase_);
    gain = moved(gain, driven, 0.0, options_.step, wheelbase_);
  }
  free.heading = wrapAngle(free.heading);
  const double push = options_.lateral_weight * gain.lateral * free.lateral +
                      options_.heading_weight * gain.heading * free.heading +
                      options_.steering_weight * gain.steering * free.steering;
  const double weight = options_.lateral_weight * gain.lateral * gain.lateral +
                        options_.heading_weight * gain.heading * gain.heading +
                        options_.steering_weight * gain.steering * gain.steering +
                        options_.steering_rate_weight;
  return -push / weight;
}

}  // namespace forge
