#include "collision_forge/attack/forecast/speed_model.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "collision_forge/attack/forecast/speed_situations.h"
#include "collision_forge/base/scene/number_words.h"

namespace forge {
namespace {

constexpr double kWeightTolerance = 1e-3;  // allowed error of the sum of rounded weights
constexpr double kMinShare = 1e-6;         // weight of a profile whose share is negative
constexpr double kLargestWeight = 1e6;     // larger weights are damage; fitted ones are below 1000
constexpr double kLargestGain = 1e3;       // m/s; larger speeds are damage

void checkMatrix(const Eigen::MatrixXd& matrix, Eigen::Index rows, Eigen::Index columns,
                 const std::string& field) {
  const auto text = [](Eigen::Index r, Eigen::Index c) {
    return std::to_string(r) + " x " + std::to_string(c);
  };
  if (matrix.rows() != rows || matrix.cols() != columns) {
    throw std::invalid_argument(field + " is " + text(matrix.rows(), matrix.cols()) + ", not " +
                                text(rows, columns));
  }
  if (!(matrix.array().abs() <= kLargestWeight).all()) {
    throw std::invalid_argument(field + " has a value beyond " +
                                std::to_string(static_cast<int>(kLargestWeight)));
  }
}

void checkProfiles(const WeightedProfiles& profiles, Eigen::Index intervals,
                   const std::string& field) {
  checkMatrix(profiles.weights, profiles.profiles.rows(), 1, field + ".weights");
  checkMatrix(profiles.profiles, profiles.weights.size(), intervals, field + ".profiles");
  if ((profiles.weights.array() < 0.0).any()) {
    throw std::invalid_argument(field + ".weights has a negative value");
  }
  const double sum = profiles.weights.sum();
  if (std::abs(sum - 1.0) > kWeightTolerance) {
    throw std::invalid_argument(field + ".weights sum to " + numberText(sum) + ", not 1");
  }
}

SpeedForecast gaining(const Eigen::MatrixXd& gains, const Eigen::VectorXd& weights, double speed) {
  if (!(gains.array().abs() <= kLargestGain).all() || !weights.allFinite()) {
    throw std::runtime_error("the speed model predicts speeds beyond " +
                             std::to_string(static_cast<int>(kLargestGain)) +
                             " m/s: its weights are damaged");
  }
  return {(gains.array() + speed).cwiseMax(0.0), weights / weights.sum()};
}

}  // namespace

void checkWeights(const SpeedModelWeights& weights) {
  const Eigen::Index intervals = weights.gains.cols();
  const Eigen::Index linear = 1 + kSpeedFeatures;
  const Eigen::Index basis = linear + weights.centers.rows();
  if (intervals == 0) throw std::invalid_argument("gains is empty");
  checkMatrix(weights.feature_weights, 1, kSpeedFeatures, "feature_weights");
  checkMatrix(weights.lowest, 1, kSpeedFeatures, "lowest");
  checkMatrix(weights.highest, 1, kSpeedFeatures, "highest");
  checkMatrix(weights.centers, weights.centers.rows(), kSpeedFeatures, "centers");
  checkMatrix(weights.gains, basis, intervals, "gains");
  checkMatrix(weights.log_spreads, basis, intervals, "log_spreads");
  checkProfiles(weights.residuals, intervals, "residuals");
  if (!std::isfinite(weights.standing_speed)) {
    throw std::invalid_argument("standing_speed is not finite");
  }
  checkMatrix(weights.standing_shares, linear, weights.standing.rows(), "standing_shares");
  if (weights.standing.rows() > 0) {
    checkMatrix(weights.standing, weights.standing.rows(), intervals, "standing");
  }
}

Eigen::MatrixXd basisOf(const Eigen::ArrayXXd& features, const SpeedModelWeights& weights) {
  Eigen::ArrayXXd scaled = features.rowwise() * weights.feature_weights.array();
  for (Eigen::Index i = 0; i < scaled.rows(); ++i) {
    scaled.row(i) =
        scaled.row(i).cwiseMax(weights.lowest.array()).cwiseMin(weights.highest.array());
  }
  const Eigen::Index count = weights.centers.rows();
  Eigen::MatrixXd basis(scaled.rows(), 1 + scaled.cols() + count);
  basis.col(0).setOnes();
  basis.middleCols(1, scaled.cols()) = scaled;
  auto nearness = basis.rightCols(count).array();
  nearness.setOnes();
  for (Eigen::Index feature = 0; feature < scaled.cols(); ++feature) {
    nearness += (scaled.col(feature).replicate(1, count).rowwise() -
                 weights.centers.col(feature).transpose().array())
                    .square();
  }
  nearness = nearness.sqrt().inverse().eval();
  return basis;
}

SpeedModel::SpeedModel(SpeedModelWeights weights, std::vector<SpeedModelWeights> folds)
    : weights_(std::move(weights)), folds_(std::move(folds)) {
  checkWeights(weights_);
}

SpeedForecast SpeedModel::forecast(const DrivingSituation& situation, int intervals) const {
  const Eigen::Index known = std::min<Eigen::Index>(intervals, weights_.gains.cols());
  const double speed = situation.past_speeds[0];
  const Eigen::MatrixXd basis = basisOf(featuresOf(situation).transpose(), weights_);
  if (speed < weights_.standing_speed && weights_.standing.rows() > 0) {
    const Eigen::RowVectorXd shares =
        basis.leftCols(weights_.standing_shares.rows()) * weights_.standing_shares;
    return gaining(weights_.standing.leftCols(known), shares.transpose().cwiseMax(kMinShare),
                   speed);
  }
  const Eigen::RowVectorXd expected = basis * weights_.gains.leftCols(known);
  const Eigen::RowVectorXd spreads =
      (basis * weights_.log_spreads.leftCols(known)).array().exp().matrix();
  const Eigen::MatrixXd differences =
      weights_.residuals.profiles.leftCols(known) * spreads.asDiagonal();
  return gaining(differences.rowwise() + expected, weights_.residuals.weights, speed);
}

}  // namespace forge
