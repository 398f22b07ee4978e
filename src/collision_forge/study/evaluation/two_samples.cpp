#include "collision_forge/study/evaluation/two_samples.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <random>

namespace forge {
namespace {

constexpr std::size_t kLeastPairs = 20;
constexpr std::size_t kFolds = 5;
constexpr int kSwaps = 100;  // random swaps of the pairs for chance_area

/// Rows of features: the `first` of all pairs, then the `second`.
struct Rows {
  Eigen::MatrixXd values;          ///< with a column of ones
  std::vector<std::size_t> folds;  ///< by pair
  std::size_t fold_count = 0;
};

Rows rowsOf(const TwoSamples& samples) {
  const auto pairs = static_cast<Eigen::Index>(samples.first.size());
  const Eigen::Index features = samples.first.front().size();
  Rows rows;
  rows.values.setOnes(2 * pairs, 1 + 2 * features);
  for (Eigen::Index i = 0; i < pairs; ++i) {
    rows.values.block(i, 1, 1, features) = samples.first[i].transpose();
    rows.values.block(pairs + i, 1, 1, features) = samples.second[i].transpose();
  }
  const auto standardise = [&](Eigen::Index column) {
    auto values = rows.values.col(column);
    values.array() -= values.mean();
    const double deviation = std::sqrt(values.squaredNorm() / static_cast<double>(2 * pairs));
    if (deviation > 0.0) values /= deviation;
  };
  for (Eigen::Index column = 1; column <= features; ++column) {
    standardise(column);
    rows.values.col(features + column) = rows.values.col(column).array().square();
    standardise(features + column);
  }
  std::map<std::string, std::size_t> groups;
  for (const std::string& group : samples.groups) {
    rows.folds.push_back(groups.try_emplace(group, groups.size()).first->second % kFolds);
  }
  rows.fold_count = std::min(kFolds, groups.size());
  return rows;
}

/// Returns the weights of a logistic regression (Newton's method). `labels`: 0 or 1.
Eigen::VectorXd fit(const Eigen::MatrixXd& rows, const Eigen::VectorXd& labels) {
  constexpr int kMostSteps = 25;
  constexpr double kPenalty = 1.0;  // of all weights but the constant's
  Eigen::VectorXd penalty = Eigen::VectorXd::Constant(rows.cols(), kPenalty);
  penalty[0] = 1e-6;
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(rows.cols());
  for (int step = 0; step < kMostSteps; ++step) {
    const Eigen::ArrayXd chance = 1.0 / (1.0 + (-(rows * weights).array()).exp());
    const Eigen::VectorXd slope =
        rows.transpose() * (chance.matrix() - labels) + penalty.cwiseProduct(weights);
    const Eigen::ArrayXd curvature = chance * (1.0 - chance);
    Eigen::MatrixXd hessian = rows.transpose() * curvature.matrix().asDiagonal() * rows;
    hessian.diagonal() += penalty;
    const Eigen::VectorXd change = hessian.ldlt().solve(slope);
    weights -= change;
    if (change.norm() < 1e-6) break;
  }
  return weights;
}

/// Returns the mean area over the folds. `swapped`: by pair, whether its two change their labels.
double meanArea(const Rows& rows, const std::vector<bool>& swapped) {
  const std::size_t pairs = rows.folds.size();
  const auto labelOf = [&](std::size_t row) { return (row >= pairs) != swapped[row % pairs]; };
  double sum = 0.0;
  for (std::size_t fold = 0; fold < rows.fold_count; ++fold) {
    std::vector<Eigen::Index> train;
    for (std::size_t row = 0; row < 2 * pairs; ++row) {
      if (rows.folds[row % pairs] != fold) train.push_back(static_cast<Eigen::Index>(row));
    }
    Eigen::VectorXd labels(static_cast<Eigen::Index>(train.size()));
    for (std::size_t i = 0; i < train.size(); ++i) {
      labels[static_cast<Eigen::Index>(i)] =
          labelOf(static_cast<std::size_t>(train[i])) ? 1.0 : 0.0;
    }
    const Eigen::VectorXd weights = fit(rows.values(train, Eigen::all), labels);
    std::vector<double> low;
    std::vector<double> high;
    for (std::size_t row = 0; row < 2 * pairs; ++row) {
      if (rows.folds[row % pairs] != fold) continue;
      const double score = rows.values.row(static_cast<Eigen::Index>(row)) * weights;
      (labelOf(row) ? high : low).push_back(score);
    }
    sum += areaUnderCurve(low, high);
  }
  return sum / static_cast<double>(rows.fold_count);
}

}  // namespace

double areaUnderCurve(const std::vector<double>& low, const std::vector<double>& high) {
  double wins = 0.0;
  for (const double above : high) {
    for (const double below : low) wins += above > below ? 1.0 : above == below ? 0.5 : 0.0;
  }
  return wins / static_cast<double>(low.size() * high.size());
}

std::optional<TwoSampleArea> separate(const TwoSamples& samples, std::uint64_t seed) {
  if (samples.first.size() < kLeastPairs) return std::nullopt;
  const Rows rows = rowsOf(samples);
  if (rows.fold_count < 2) return std::nullopt;
  std::vector<bool> swapped(samples.first.size(), false);
  TwoSampleArea result;
  result.area = meanArea(rows, swapped);
  std::mt19937_64 random(seed);
  std::vector<double> chance;
  for (int i = 0; i < kSwaps; ++i) {
    for (std::size_t pair = 0; pair < swapped.size(); ++pair) swapped[pair] = random() & 1U;
    chance.push_back(meanArea(rows, swapped));
  }
  std::sort(chance.begin(), chance.end());
  result.chance_area = chance[static_cast<std::size_t>(0.95 * kSwaps)];
  return result;
}

}  // namespace forge
