#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace forge {

/// Two samples of equal size. Element i of both belongs to the same thing, measured in two ways.
struct TwoSamples {
  std::vector<Eigen::VectorXd> first, second;  ///< features, all of one size, finite
  std::vector<std::string> groups;  ///< of each pair; pairs of a group depend on each other
};

/// How well a classifier separates two samples.
struct TwoSampleArea {
  double area = 0.5;  ///< under the ROC curve: 0.5 for equal distributions
  /// 95 % quantile of the area if the two of each pair are swapped at random.
  double chance_area = 0.5;
};

/// Returns the area under the ROC curve of a score: the probability that a value of `high` exceeds
/// a value of `low`, ties counted half. Both must not be empty.
double areaUnderCurve(const std::vector<double>& low, const std::vector<double>& high);

/// Trains a classifier (logistic regression with an L2 penalty of 1, on the standardised features
/// and their squares) to separate `first` from `second`, and tests it on groups outside its
/// training set: five folds, each group in one of them, mean of the folds' areas. Equal
/// distributions may give an area below 0.5. nullopt for fewer than 20 pairs or fewer than two
/// groups. Classifier two-sample test: Lopez-Paz and Oquab, ICLR 2017.
std::optional<TwoSampleArea> separate(const TwoSamples& samples, std::uint64_t seed);

}  // namespace forge
