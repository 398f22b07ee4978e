#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/study/options.h"

namespace forge {

// The classifier two-sample test (Lopez-Paz and Oquab, "Revisiting Classifier Two-Sample Tests",
// ICLR 2017): who cannot be told apart by a classifier on scenes that it was not trained on, is
// alike. The measure is the area under the curve of its scores: the probability that one of the
// first sample scores above one of the second, a half where nothing tells them apart.

/// Things with features, each of a scene.
struct FeatureTable {
  Eigen::MatrixXd features;         ///< a row a thing
  std::vector<std::string> scenes;  ///< for each row
};

/// The share of pairs of which the positive has the higher score, equal ones counting a half
/// (Mann-Whitney, with mid-ranks). Throws std::invalid_argument without scores on a side.
double areaUnderCurve(const std::vector<double>& positives, const std::vector<double>& negatives);

/// Standard error of areaUnderCurve() of two samples of one distribution: sqrt((m + n + 1) / (12 m
/// n)) (Mann and Whitney 1947). Things of one scene depend on each other; it does not know of that.
double areaStandardError(std::size_t positives, std::size_t negatives);

/// Logistic regression with a ridge on the weights of standardised features.
class LogisticRegression {
 public:
  /// Newton's method. `labels`: 1 or 0, one a row of `features`. Minimises the sum of the logistic
  /// losses and ridge / 2 times the squared norm of the weights. Features that do not vary count
  /// nothing.
  LogisticRegression(const Eigen::MatrixXd& features, const Eigen::VectorXd& labels, double ridge);

  /// The log odds of label 1, one a row.
  Eigen::VectorXd scores(const Eigen::MatrixXd& features) const;

 private:
  Eigen::RowVectorXd mean_;
  Eigen::RowVectorXd scale_;  // 1 / standard deviation
  Eigen::VectorXd weights_;   // the constant first
};

/// Gradient boosting of trees of depth two on the logistic loss, by second-order steps (Friedman
/// 2001; leaves and gains as of Chen and Guestrin 2016, Eq. 5 to 7).
class BoostedForest {
 public:
  /// `labels` as above. The same arguments give the same forest.
  BoostedForest(const Eigen::MatrixXd& features, const Eigen::VectorXd& labels,
                const ForestOptions& options);

  /// The log odds of label 1, one a row.
  Eigen::VectorXd scores(const Eigen::MatrixXd& features) const;

 private:
  /// Rows with a feature of at most `threshold` go to the first side.
  struct Split {
    Eigen::Index feature = 0;
    double threshold = 0.0;
  };
  /// A split, of each side another, of each of its sides a leaf.
  struct Tree {
    Split root;
    Split sides[2];
    double leaves[2][2] = {};
  };
  class Grower;

  static double scoreOf(const Tree& tree, const Eigen::MatrixXd& features, Eigen::Index row);

  double constant_ = 0.0;
  std::vector<Tree> trees_;  // leaves already shrunk by the learning rate
};

/// How well two samples are told apart.
struct TwoSampleTest {
  double logistic = 0.5;  ///< areas under the curve
  double forest = 0.5;
  double standard_error = 0.0;  ///< of either, where nothing tells the samples apart
  std::size_t first = 0;        ///< sizes of the samples
  std::size_t second = 0;

  /// What counts.
  double larger() const { return logistic > forest ? logistic : forest; }
};

/// Trains both classifiers on one half of the scenes and tests them on the other, both ways; pairs
/// are counted within a half, for the scores of two classifiers have no common zero. Scenes with
/// things of both samples, of the first alone and of the second alone are halved each by
/// themselves, at random by the seed. Empty where a half lacks one of the samples.
std::optional<TwoSampleTest> testTwoSamples(const FeatureTable& first, const FeatureTable& second,
                                            const ClassifierOptions& options, std::uint64_t seed);

}  // namespace forge
