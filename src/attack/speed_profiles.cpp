#include "attack/speed_profiles.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace forge {
namespace {

constexpr std::size_t kMinProfiles = 8;    // fewer give no spread
constexpr std::size_t kRowsANeighbor = 4;  // a small collection is not averaged over as a whole

/// What situations are compared by, of order one, in the order of feature_weights.
Eigen::ArrayXd featuresOf(const DrivingSituation& situation) {
  const auto& speed = situation.past_speeds;
  const WayAhead& ahead = situation.ahead;
  Eigen::ArrayXd features(kSpeedFeatures);
  features << speed[0], (speed[0] - speed[1]) / kProfileStep, (speed[1] - speed[2]) / kProfileStep,
      (speed[2] - speed[4]) / (2 * kProfileStep), ahead.turn_rate, ahead.bend_braking,
      ahead.bend_turn, 10.0 * ahead.bend_curvature, ahead.headway, ahead.closing;
  return features;
}

bool isFinite(const SpeedProfileRow& row) {
  const WayAhead& ahead = row.ahead;
  return std::isfinite(row.speed + ahead.turn_rate + ahead.bend_braking + ahead.bend_turn +
                       ahead.bend_curvature + ahead.headway + ahead.closing);
}

bool follows(const SpeedProfileRow& row, const SpeedProfileRow& before) {
  return row.scene == before.scene && row.frame == before.frame + 1;
}

}  // namespace

SpeedProfiles::SpeedProfiles(std::vector<SpeedProfileRow> rows)
    : rows_(std::move(rows)), lasts_(rows_.size(), 0) {
  features_.resize(static_cast<Eigen::Index>(rows_.size()), kSpeedFeatures);
  DrivingSituation situation;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const SpeedProfileRow& row = rows_[i];
    const std::string place =
        "speed profile row of " + row.scene + ", frame " + std::to_string(row.frame);
    if (!isFinite(row)) throw std::invalid_argument(place + " has a value that is not finite");
    const bool same_scene = i > 0 && rows_[i - 1].scene == row.scene;
    if (same_scene ? row.frame <= rows_[i - 1].frame : scene_numbers_.count(row.scene) > 0) {
      throw std::invalid_argument(place + " does not come in order");
    }
    scene_of_.push_back(
        scene_numbers_.emplace(row.scene, static_cast<int>(scene_numbers_.size())).first->second);
    auto& past = situation.past_speeds;
    if (i > 0 && follows(row, rows_[i - 1])) {
      std::copy_backward(past.begin(), past.end() - 1, past.end());
      past.front() = row.speed;
    } else {
      past.fill(row.speed);
    }
    situation.ahead = row.ahead;
    features_.row(static_cast<Eigen::Index>(i)) = featuresOf(situation).transpose();
  }
  for (std::size_t i = rows_.size(); i-- > 1;) {
    if (follows(rows_[i], rows_[i - 1])) lasts_[i - 1] = lasts_[i] + 1;
  }
}

int SpeedProfiles::sceneNumber(const std::string& name) const {
  const auto found = scene_numbers_.find(name);
  return found == scene_numbers_.end() ? -1 : found->second;
}

SpeedProfiles::Extent SpeedProfiles::extentOf(int intervals, std::size_t neighbors,
                                              int left_out) const {
  std::vector<std::size_t> ending(static_cast<std::size_t>(intervals) + 1, 0);
  std::size_t usable = 0;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (scene_of_[i] == left_out) continue;
    ++ending[static_cast<std::size_t>(std::min(lasts_[i], intervals))];
    ++usable;
  }
  const std::size_t wanted = std::max(std::min(neighbors, usable / kRowsANeighbor), kMinProfiles);
  std::size_t lasting = 0;
  for (int last = intervals; last > 0; --last) {
    lasting += ending[static_cast<std::size_t>(last)];
    if (lasting >= wanted) return {last, wanted};
  }
  return {};
}

SpeedProfiles::Neighbors SpeedProfiles::nearest(const Eigen::ArrayXd& features, int intervals,
                                                std::size_t wanted, int left_out,
                                                const FeatureWeights& weights) const {
  Eigen::ArrayXd distances = Eigen::ArrayXd::Zero(features_.rows());
  for (Eigen::Index column = 0; column < features_.cols(); ++column) {
    const double weight = weights[static_cast<std::size_t>(column)];
    if (weight == 0.0) continue;
    distances += (weight * (features_.col(column) - features[column])).square();
  }
  Neighbors neighbors;
  neighbors.reserve(rows_.size());
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (lasts_[i] < intervals || scene_of_[i] == left_out) continue;
    const auto row = static_cast<Eigen::Index>(i);
    neighbors.emplace_back(distances[row], row);
  }
  const auto end = neighbors.begin() + static_cast<std::ptrdiff_t>(wanted);
  if (end != neighbors.end()) std::nth_element(neighbors.begin(), end, neighbors.end());
  neighbors.erase(end, neighbors.end());
  std::sort(neighbors.begin(), neighbors.end());
  return neighbors;
}

SpeedForecast SpeedProfiles::forecast(const DrivingSituation& situation, int intervals,
                                      const SpeedProfileOptions& options,
                                      const std::string& left_out_scene) const {
  const int left_out = sceneNumber(left_out_scene);
  const Extent extent = extentOf(intervals, static_cast<std::size_t>(options.neighbors), left_out);
  if (extent.intervals == 0) return {};
  const Eigen::ArrayXd features = featuresOf(situation);
  const Neighbors neighbors =
      nearest(features, extent.intervals, extent.neighbors, left_out, options.feature_weights);

  const auto count = static_cast<Eigen::Index>(neighbors.size());
  const double reach = std::max(neighbors.back().first, std::numeric_limits<double>::min());
  Eigen::MatrixXd design(count, kSpeedFeatures + 1);
  Eigen::MatrixXd gains(count, extent.intervals);  // of speed since the profile's start
  SpeedForecast forecast;
  forecast.weights.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto& [distance, row] = neighbors[static_cast<std::size_t>(i)];
    forecast.weights[i] = std::max(1.0 - distance / reach, 1e-6);
    design.row(i) << 1.0, (features_.row(row) - features.transpose()).matrix();
    const auto start = static_cast<std::size_t>(row);
    for (int j = 0; j < extent.intervals; ++j) {
      gains(i, j) = rows_[start + static_cast<std::size_t>(j) + 1].speed - rows_[start].speed;
    }
  }
  forecast.weights /= forecast.weights.sum();

  const Eigen::MatrixXd weighted = forecast.weights.asDiagonal() * design;
  Eigen::MatrixXd normal = weighted.transpose() * design;
  normal.diagonal().tail(kSpeedFeatures).array() += options.ridge / static_cast<double>(count);
  const Eigen::MatrixXd coefficients = normal.ldlt().solve(weighted.transpose() * gains);
  const Eigen::MatrixXd residuals = options.residual_scale * (gains - design * coefficients);
  const Eigen::RowVectorXd expected = coefficients.row(0).array() + situation.past_speeds[0];
  forecast.speeds = (residuals.rowwise() + expected).cwiseMax(0.0);
  return forecast;
}

}  // namespace forge
