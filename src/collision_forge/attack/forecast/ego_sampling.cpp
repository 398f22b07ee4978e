#include "collision_forge/attack/forecast/ego_sampling.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "collision_forge/attack/forecast/kinematic_prediction.h"
#include "collision_forge/attack/forecast/motion_estimate.h"
#include "collision_forge/base/scene/number_words.h"

namespace forge {
namespace {

// Lateral motion on a lane, fitted to 339 recorded scenes of nuScenes:
constexpr double kLaneReturnTime = 1.1;  // s in which an offset from the path returns by about 1/e
constexpr double kLaneReturnMinDistance = 5.0;  // m, the same for a slow ego
constexpr double kRankingTime = 4.0;          // s after t0, until which distances rank the profiles
constexpr Eigen::Index kFadingProfiles = 64;  // of a forecast without recorded profiles
constexpr double kMonotone = 3.0;  // bound on slope / lower mean speed for a monotone Hermite cubic

/// Quantile of a two-sided exponential (Laplace) distribution.
double difference(double share, double mean_difference) {
  const double side = 2.0 * share - 1.0;
  return -std::copysign(mean_difference, side) * std::log(1.0 - std::abs(side));
}

/// Returns profiles whose accelerations, spread around the one at t0, decay.
SpeedForecast fadingAccelerations(const std::array<double, 5>& past_speeds, int intervals,
                                  const EgoFutureOptions& options) {
  SpeedForecast forecast;
  forecast.speeds.resize(kFadingProfiles, intervals);
  forecast.weights.setConstant(kFadingProfiles, 1.0 / static_cast<double>(kFadingProfiles));
  const double present = (past_speeds[0] - past_speeds[2]) / (2.0 * kProfileStep);
  const double fading = options.acceleration_fading;
  for (Eigen::Index i = 0; i < kFadingProfiles; ++i) {
    const double share = (static_cast<double>(i) + 0.5) / kFadingProfiles;
    const double acceleration = present + difference(share, options.acceleration_spread);
    for (int j = 0; j < intervals; ++j) {
      const double gained = 1.0 - std::exp(-(j + 1) * kProfileStep / fading);
      const double speed = past_speeds[0] + acceleration * fading * gained;
      forecast.speeds(i, j) = std::max(speed, 0.0);
    }
  }
  return forecast;
}

/// Returns fadingAccelerations() and as many profiles of braking to a standstill, half of the
/// weight each; speeds are backwards.
SpeedForecast reversingSpeeds(const std::array<double, 5>& past_speeds, int intervals,
                              const EgoFutureOptions& options) {
  const SpeedForecast fading = fadingAccelerations(past_speeds, intervals, options);
  SpeedForecast forecast;
  forecast.speeds.resize(2 * kFadingProfiles, intervals);
  forecast.speeds.topRows(kFadingProfiles) = fading.speeds;
  for (Eigen::Index i = 0; i < kFadingProfiles; ++i) {
    const double stop = kReverseStop * (static_cast<double>(i) + 0.5) / kFadingProfiles;
    for (int j = 0; j < intervals; ++j) {
      const double left = 1.0 - (j + 0.5) * kProfileStep / stop;
      forecast.speeds(kFadingProfiles + i, j) = past_speeds[0] * std::max(left, 0.0);
    }
  }
  forecast.weights.setConstant(2 * kFadingProfiles, 0.5 / static_cast<double>(kFadingProfiles));
  return forecast;
}

}  // namespace

std::vector<double> drawDifferences(int count, double mean_difference, std::mt19937_64& engine) {
  const EvenDraws draw(count, engine);
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(difference(draw(i), mean_difference));
  for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[engine() % i]);
  return values;
}

std::vector<int> shareOut(const std::vector<double>& weights, int count, std::mt19937_64& engine) {
  const EvenDraws draw(count, engine);
  std::vector<int> shares(weights.size(), 0);
  std::size_t choice = 0;
  double upper = weights.front();
  for (int i = 0; i < count; ++i) {
    while (draw(i) > upper && choice + 1 < weights.size()) upper += weights[++choice];
    ++shares[choice];
  }
  return shares;
}

SpeedForecast forecastSpeeds(const SpeedForecaster* speeds, const DrivingSituation& situation,
                             double horizon, const EgoFutureOptions& options) {
  const int intervals = static_cast<int>(std::ceil(horizon / kProfileStep - 1e-9));
  SpeedForecast forecast;
  if (speeds) forecast = speeds->forecast(situation, intervals);
  if (forecast.speeds.cols() == 0) {
    forecast = fadingAccelerations(situation.past_speeds, intervals, options);
  }
  return forecast;
}

std::vector<Eigen::Index> drawProfiles(const SpeedForecast& forecast, int count,
                                       std::mt19937_64& engine) {
  const auto ranked =
      std::min(forecast.speeds.cols(), static_cast<Eigen::Index>(kRankingTime / kProfileStep));
  const Eigen::VectorXd driven = forecast.speeds.leftCols(ranked).rowwise().sum();
  std::vector<Eigen::Index> order(static_cast<std::size_t>(driven.size()));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
    return std::make_pair(driven[a], a) < std::make_pair(driven[b], b);
  });
  const EvenDraws draw(count, engine);
  std::vector<Eigen::Index> drawn;
  std::size_t at = 0;
  double upper = forecast.weights[order.front()];
  for (int i = 0; i < count; ++i) {
    while (draw(i) > upper && at + 1 < order.size()) upper += forecast.weights[order[++at]];
    drawn.push_back(order[at]);
  }
  return drawn;
}

DrivenDistance::DrivenDistance(double past_speed, const Eigen::RowVectorXd& speeds) {
  double before = std::max(past_speed, 0.0);
  double distance = 0.0;
  for (const double speed : speeds) {
    nodes_.push_back(
        {distance, std::min(0.5 * (before + speed), kMonotone * std::min(before, speed))});
    distance += speed * kProfileStep;
    before = speed;
  }
  nodes_.push_back({distance, before});
}

double DrivenDistance::at(double time) const {
  const double position = time / kProfileStep;
  const auto i = static_cast<std::size_t>(position);
  if (i + 1 >= nodes_.size()) {
    const double beyond = position - static_cast<double>(nodes_.size() - 1);
    return nodes_.back().distance + beyond * kProfileStep * nodes_.back().speed;
  }
  const Node& a = nodes_[i];
  const Node& b = nodes_[i + 1];
  const double u = position - static_cast<double>(i);
  const double rise = b.distance - a.distance;
  const double start = a.speed * kProfileStep;
  const double end = b.speed * kProfileStep;
  return a.distance +
         u * (start + u * (3.0 * rise - 2.0 * start - end + u * (start + end - 2.0 * rise)));
}

ReturnToPath::ReturnToPath(const SampledPath& path, const EgoNow& ego, double offset_difference)
    : path_(path) {
  const Pose2 local = relativeTo(path.poses().front(), ego.state.pose);
  start_ = local.x;
  target_ = kKeptOffset * local.y + offset_difference;
  lateral_ = local.y - target_;
  return_distance_ = std::max(kLaneReturnTime * ego.past_speeds[0], kLaneReturnMinDistance);
  slope_ = std::tan(local.yaw);
  rate_ = slope_ + lateral_ / return_distance_;
}

Pose2 ReturnToPath::poseAfter(double driven) const {
  const double fade = std::exp(-driven / return_distance_);
  const double offset = target_ + fade * (lateral_ + rate_ * driven);
  const double slope = fade * (slope_ - rate_ * driven / return_distance_);
  Pose2 pose = path_.poseAt(start_ + driven, offset);
  pose.yaw = wrapAngle(pose.yaw + std::atan(slope));
  return pose;
}

Track drive(const Track& ego, const EgoNow& now, const DrivenDistance& distance,
            const ReturnToPath& way, double horizon, double step) {
  Track track{ego.id, ego.agent_class, ego.size, {}};
  const int steps = static_cast<int>(std::ceil(horizon / step - 1e-9));
  track.states.reserve(static_cast<std::size_t>(steps) + 1);
  track.states.push_back(now.state);
  for (int i = 1; i <= steps; ++i) {
    const double time = i * step;
    track.states.push_back(
        {now.state.time + time, way.poseAfter(distance.at(time)), Vector2::Zero()});
  }
  deriveVelocities(track);
  track.states.front().velocity = now.state.velocity;
  return track;
}

bool isReversing(const EgoNow& ego) { return ego.past_speeds[0] < -kStandstillSpeed; }

std::vector<Track> reversingFutures(const Track& ego, const EgoNow& now, double horizon, int count,
                                    const EgoFutureOptions& options, std::mt19937_64& engine) {
  EgoNow turned = now;  // drives forwards in its direction of motion
  turned.state.pose.yaw = wrapAngle(now.state.pose.yaw + M_PI);
  for (double& speed : turned.past_speeds) speed = -speed;
  const int intervals = static_cast<int>(std::ceil(horizon / kProfileStep - 1e-9));
  const SpeedForecast forecast = reversingSpeeds(turned.past_speeds, intervals, options);
  const auto profiles = drawProfiles(forecast, count, engine);
  const auto turns = drawDifferences(count, options.turn_rate_spread, engine);
  std::vector<Track> tracks;
  for (std::size_t i = 0; i < profiles.size(); ++i) {
    const DrivenDistance distance(turned.past_speeds[0], forecast.speeds.row(profiles[i]));
    const SampledPath line = freePath(turned, turns[i], horizon);
    const ReturnToPath way(line, turned, 0.0);
    tracks.push_back(drive(ego, turned, distance, way, horizon, kPredictionStep));
    auto& states = tracks.back().states;
    for (AgentState& state : states) state.pose.yaw = wrapAngle(state.pose.yaw - M_PI);
    states.front() = now.state;
  }
  return tracks;
}

void checkSampleArguments(double horizon, int count) {
  if (!(horizon > 0.0 && std::isfinite(horizon))) {
    throw std::invalid_argument("horizon = " + numberText(horizon) +
                                " s: it must be positive and finite");
  }
  if (count < 0)
    throw std::invalid_argument("count = " + std::to_string(count) + ": it must not be negative");
}

}  // namespace forge
