#include "collision_forge/attack/forecast/speed_profiles.h"

#include <Eigen/Dense>
#include <algorithm>
#include <limits>
#include <utility>

namespace forge {
namespace {

constexpr std::size_t kMinProfiles = 8;    // fewer give no spread
constexpr std::size_t kRowsANeighbor = 4;  // a small collection is not averaged over as a whole

}  // namespace

SpeedProfiles::SpeedProfiles(SpeedSituations recorded, const SpeedProfileOptions& options)
    : recorded_(std::make_shared<const SpeedSituations>(std::move(recorded))), options_(options) {}

SpeedProfiles::Extent SpeedProfiles::extentOf(int intervals) const {
  std::vector<std::size_t> ending(static_cast<std::size_t>(intervals) + 1, 0);
  std::size_t usable = 0;
  for (Eigen::Index row = 0; row < recorded_->size(); ++row) {
    if (recorded_->sceneOf(row) == left_out_) continue;
    ++ending[static_cast<std::size_t>(std::min(recorded_->lasts(row), intervals))];
    ++usable;
  }
  const auto neighbors = static_cast<std::size_t>(options_.neighbors);
  const std::size_t wanted = std::max(std::min(neighbors, usable / kRowsANeighbor), kMinProfiles);
  std::size_t lasting = 0;
  for (int last = intervals; last > 0; --last) {
    lasting += ending[static_cast<std::size_t>(last)];
    if (lasting >= wanted) return {last, wanted};
  }
  return {};
}

SpeedProfiles::Neighbors SpeedProfiles::nearest(const Eigen::ArrayXd& features,
                                                const Extent& extent) const {
  const Eigen::ArrayXXd& recorded = recorded_->features();
  Eigen::ArrayXd distances = Eigen::ArrayXd::Zero(recorded.rows());
  for (Eigen::Index column = 0; column < recorded.cols(); ++column) {
    const double weight = options_.feature_weights[static_cast<std::size_t>(column)];
    if (weight == 0.0) continue;
    distances += (weight * (recorded.col(column) - features[column])).square();
  }
  Neighbors neighbors;
  neighbors.reserve(static_cast<std::size_t>(recorded.rows()));
  for (Eigen::Index row = 0; row < recorded.rows(); ++row) {
    if (recorded_->lasts(row) < extent.intervals || recorded_->sceneOf(row) == left_out_) continue;
    neighbors.emplace_back(distances[row], row);
  }
  const auto end = neighbors.begin() + static_cast<std::ptrdiff_t>(extent.neighbors);
  if (end != neighbors.end()) std::nth_element(neighbors.begin(), end, neighbors.end());
  neighbors.erase(end, neighbors.end());
  std::sort(neighbors.begin(), neighbors.end());
  return neighbors;
}

std::shared_ptr<const SpeedForecaster> SpeedProfiles::withoutScene(const std::string& scene) const {
  const int number = recorded_->sceneNumber(scene);
  if (number < 0) return nullptr;
  auto other = std::make_shared<SpeedProfiles>(*this);
  other->left_out_ = number;
  return other;
}

SpeedForecast SpeedProfiles::forecast(const DrivingSituation& situation, int intervals) const {
  const Extent extent = extentOf(intervals);
  if (extent.intervals == 0) return {};
  const Eigen::ArrayXd features = featuresOf(situation);
  const Neighbors neighbors = nearest(features, extent);

  const auto count = static_cast<Eigen::Index>(neighbors.size());
  const double reach = std::max(neighbors.back().first, std::numeric_limits<double>::min());
  Eigen::MatrixXd design(count, kSpeedFeatures + 1);
  Eigen::MatrixXd gains(count, extent.intervals);  // of speed since the profile's start
  SpeedForecast forecast;
  forecast.weights.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto& [distance, row] = neighbors[static_cast<std::size_t>(i)];
    forecast.weights[i] = std::max(1.0 - distance / reach, 1e-6);
    design.row(i) << 1.0, (recorded_->features().row(row) - features.transpose()).matrix();
    for (int j = 0; j < extent.intervals; ++j) gains(i, j) = recorded_->gain(row, j);
  }
  forecast.weights /= forecast.weights.sum();

  const Eigen::MatrixXd weighted = forecast.weights.asDiagonal() * design;
  Eigen::MatrixXd normal = weighted.transpose() * design;
  normal.diagonal().tail(kSpeedFeatures).array() += options_.ridge / static_cast<double>(count);
  const Eigen::MatrixXd coefficients = normal.ldlt().solve(weighted.transpose() * gains);
  const Eigen::MatrixXd residuals = options_.residual_scale * (gains - design * coefficients);
  const Eigen::RowVectorXd expected = coefficients.row(0).array() + situation.past_speeds[0];
  forecast.speeds = (residuals.rowwise() + expected).cwiseMax(0.0);
  return forecast;
}

}  // namespace forge
