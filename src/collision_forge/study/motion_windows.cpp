#include "collision_forge/study/motion_windows.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "collision_forge/scene/clock.h"
#include "collision_forge/study/scene_halves.h"

namespace forge {
namespace {

constexpr std::size_t kMiddle = kWindowSamples / 2;
constexpr double kShortestStep = 0.25;  // s between neighbours of a recorded window
constexpr double kLongestStep = 0.75;   // s

/// Position (x, y, yaw) and its derivatives by time at one instant.
struct Derivatives {
  Eigen::Vector3d first, second, third;
};

using SampleTimes = Eigen::Matrix<double, kWindowSamples, 1>;

/// Cubics in the time since the middle sample.
struct CubicFit {
  SampleTimes times;                         // s since the middle sample
  Eigen::Matrix<double, 4, 3> coefficients;  // a row a power, columns x, y, yaw

  Derivatives at(double time) const {
    const auto& c = coefficients;
    return {(c.row(1) + 2.0 * time * c.row(2) + 3.0 * time * time * c.row(3)).transpose(),
            (2.0 * c.row(2) + 6.0 * time * c.row(3)).transpose(), 6.0 * c.row(3).transpose()};
  }
};

/// x and y since the middle sample, yaw unwrapped from there.
Eigen::Matrix<double, kWindowSamples, 3> unwrapped(const MotionWindow& window) {
  Eigen::Matrix<double, kWindowSamples, 3> positions;
  double yaw = 0.0;
  for (std::size_t i = 0; i < kWindowSamples; ++i) {
    const Pose2& pose = window.samples[i].pose;
    if (i > 0) yaw += angleBetween(window.samples[i - 1].pose.yaw, pose.yaw);
    const Vector2 offset = pose.position() - window.samples[kMiddle].pose.position();
    positions.row(static_cast<Eigen::Index>(i)) << offset.x(), offset.y(), yaw;
  }
  return positions;
}

SampleTimes timesOf(const MotionWindow& window) {
  SampleTimes times;
  for (std::size_t i = 0; i < kWindowSamples; ++i) {
    times[static_cast<Eigen::Index>(i)] = window.samples[i].time - window.samples[kMiddle].time;
  }
  return times;
}

/// A row a sample, a column a power of its time, from 0 up.
Eigen::Matrix<double, kWindowSamples, 4> powersOf(const SampleTimes& times) {
  Eigen::Matrix<double, kWindowSamples, 4> powers;
  powers.col(0).setOnes();
  for (Eigen::Index power = 1; power < 4; ++power) {
    powers.col(power) = powers.col(power - 1).cwiseProduct(times);
  }
  return powers;
}

CubicFit fitCubics(const MotionWindow& window) {
  const SampleTimes times = timesOf(window);
  return {times, powersOf(times).householderQr().solve(unwrapped(window))};
}

/// Of the single track whose yaw rate and its change are given.
Steering steeringOf(const MotionState& state, double wheelbase) {
  const double curvature = state.yaw_rate / state.speed;
  const double change =
      (state.yaw_acceleration - curvature * state.acceleration) / state.speed;  // of the curvature
  const double slope = wheelbase * curvature;
  return {std::atan(slope), wheelbase * change / (1.0 + slope * slope)};
}

MotionState stateOf(const Derivatives& derivatives, double wheelbase, double min_steering_speed) {
  MotionState state;
  const Vector2 velocity = derivatives.first.head<2>();
  state.speed = velocity.norm();
  if (state.speed > 0.0) {
    state.acceleration = derivatives.second.head<2>().dot(velocity) / state.speed;
    state.jerk = derivatives.third.head<2>().dot(velocity) / state.speed;
  }
  state.yaw_rate = derivatives.first.z();
  state.yaw_acceleration = derivatives.second.z();
  state.lateral_acceleration = state.speed * state.yaw_rate;
  if (state.speed >= min_steering_speed) state.steering = steeringOf(state, wheelbase);
  return state;
}

bool evenlySampled(const std::vector<AgentState>& states, std::size_t first) {
  for (std::size_t i = first + 1; i < first + kWindowSamples; ++i) {
    const double step = states[i].time - states[i - 1].time;
    if (step < kShortestStep || step > kLongestStep) return false;
  }
  return true;
}

bool moves(const MotionWindow& window, const MotionOptions& options) {
  const WindowMotion motion = motionOf(window, options);
  return std::all_of(motion.begin(), motion.end(),
                     [&](const MotionState& state) { return state.speed >= options.min_speed; });
}

}  // namespace

WindowMotion motionOf(const MotionWindow& window, const MotionOptions& options) {
  const CubicFit fit = fitCubics(window);
  WindowMotion motion;
  for (std::size_t i = 0; i < kWindowSamples; ++i) {
    motion[i] = stateOf(fit.at(fit.times[static_cast<Eigen::Index>(i)]),
                        options.wheelbase_share * window.size.length, options.min_steering_speed);
  }
  return motion;
}

std::vector<MotionWindow> recordedWindows(const std::string& scene, const Track& track,
                                          const MotionOptions& options) {
  std::vector<MotionWindow> windows;
  if (!canAttack(track.agent_class)) return windows;
  for (std::size_t first = 0; first + kWindowSamples <= track.states.size(); ++first) {
    if (!evenlySampled(track.states, first)) continue;
    MotionWindow window{scene, track.id, track.agent_class, track.size, {}, 0};
    for (std::size_t i = 0; i < kWindowSamples; ++i) {
      const AgentState& state = track.states[first + i];
      window.samples[i] = {state.time, state.pose};
    }
    if (moves(window, options)) windows.push_back(std::move(window));
  }
  return windows;
}

std::optional<MotionWindow> attackWindow(const std::string& scene, const Track& recorded,
                                         const AttackerTrajectory& trajectory, double contact_time,
                                         const MotionOptions& options) {
  if (trajectory.points.empty()) return std::nullopt;
  const double now = trajectory.points.front().time;
  const double left = contact_time - options.before_contact - now;
  const int newest = static_cast<int>(std::floor((left + kTimeEpsilon) / kWindowStep));
  if (newest < 1) return std::nullopt;
  MotionWindow window{scene, trajectory.attacker_id, trajectory.agent_class, trajectory.size, {},
                      0};
  window.generated = std::min<std::size_t>(static_cast<std::size_t>(newest), kWindowSamples);
  for (std::size_t i = 0; i < kWindowSamples; ++i) {
    const int step = newest + 1 + static_cast<int>(i) - static_cast<int>(kWindowSamples);
    const double time = now + step * kWindowStep;
    if (step > 0) {
      window.samples[i] = {time, poseAt(trajectory, time)};
      continue;
    }
    const std::optional<AgentState> past = stateAt(recorded, time);
    if (!past) return std::nullopt;
    window.samples[i] = {time, past->pose};
  }
  if (!moves(window, options)) return std::nullopt;
  return window;
}

std::array<Vector2, kWindowSamples> fitResiduals(const MotionWindow& window) {
  const CubicFit fit = fitCubics(window);
  const Eigen::Matrix<double, kWindowSamples, 3> left =
      unwrapped(window) - powersOf(fit.times) * fit.coefficients;
  const Vector2 ahead = window.samples[kMiddle].pose.heading();
  std::array<Vector2, kWindowSamples> residuals;
  for (std::size_t i = 0; i < kWindowSamples; ++i) {
    const Vector2 residual = left.row(static_cast<Eigen::Index>(i)).head<2>().transpose();
    residuals[i] = {ahead.dot(residual), ahead.x() * residual.y() - ahead.y() * residual.x()};
  }
  return residuals;
}

std::vector<MotionWindow> withRecordedNoise(std::vector<MotionWindow> windows,
                                            const std::vector<MotionWindow>& recorded,
                                            std::mt19937_64& generator) {
  if (recorded.empty()) return windows;
  const double scale = std::sqrt(7.0 / 3.0);
  for (MotionWindow& window : windows) {
    const auto drawn = fitResiduals(recorded[generator() % recorded.size()]);
    std::vector<Vector2> residuals(drawn.begin(), drawn.end());
    shuffle(residuals, generator);
    for (std::size_t i = kWindowSamples - window.generated; i < kWindowSamples; ++i) {
      Pose2& pose = window.samples[i].pose;
      const Pose2 moved = compose(pose, {scale * residuals[i].x(), scale * residuals[i].y(), 0.0});
      pose.x = moved.x;
      pose.y = moved.y;
    }
  }
  return windows;
}

}  // namespace forge
