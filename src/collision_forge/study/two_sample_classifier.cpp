#include "collision_forge/study/two_sample_classifier.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <set>
#include <stdexcept>
#include <utility>

#include "collision_forge/study/scene_halves.h"

namespace forge {
namespace {

/// Pairs of which the positive wins.
double wonPairs(const std::vector<double>& positives, const std::vector<double>& negatives) {
  std::vector<std::pair<double, bool>> ranked;
  for (const double score : positives) ranked.emplace_back(score, true);
  for (const double score : negatives) ranked.emplace_back(score, false);
  std::sort(ranked.begin(), ranked.end());
  double won = 0.0;
  double below = 0.0;  // negatives with a lower score
  for (std::size_t begin = 0; begin < ranked.size();) {
    double tied[2] = {};
    std::size_t end = begin;
    while (end < ranked.size() && ranked[end].first == ranked[begin].first) {
      tied[ranked[end++].second] += 1.0;
    }
    won += tied[true] * (below + 0.5 * tied[false]);
    below += tied[false];
    begin = end;
  }
  return won;
}

double pairCount(std::size_t positives, std::size_t negatives) {
  return static_cast<double>(positives) * static_cast<double>(negatives);
}

/// Of the pairs won by chance.
double wonVariance(std::size_t positives, std::size_t negatives) {
  return pairCount(positives, negatives) * static_cast<double>(positives + negatives + 1) / 12.0;
}

Eigen::VectorXd sigmoid(const Eigen::VectorXd& log_odds) {
  return (1.0 / (1.0 + (-log_odds.array()).exp())).matrix();
}

/// With a first column of ones.
Eigen::MatrixXd standardised(const Eigen::MatrixXd& features, const Eigen::RowVectorXd& mean,
                             const Eigen::RowVectorXd& scale) {
  Eigen::MatrixXd design(features.rows(), features.cols() + 1);
  design.col(0).setOnes();
  design.rightCols(features.cols()) =
      ((features.rowwise() - mean).array().rowwise() * scale.array()).matrix();
  return design;
}

/// The rows of both samples that fall into a half.
struct HalfSample {
  Eigen::MatrixXd features;
  Eigen::VectorXd labels;

  std::vector<double> ofLabel(const Eigen::VectorXd& scores, double label) const {
    std::vector<double> found;
    for (Eigen::Index row = 0; row < labels.size(); ++row) {
      if (labels[row] == label) found.push_back(scores[row]);
    }
    return found;
  }
  bool hasBoth() const {
    return labels.size() > 0 && labels.minCoeff() == 0.0 && labels.maxCoeff() == 1.0;
  }
};

HalfSample halfOf(const FeatureTable& first, const FeatureTable& second, const SceneHalves& halves,
                  int half) {
  std::vector<std::pair<const FeatureTable*, Eigen::Index>> rows;
  for (const FeatureTable* table : {&first, &second}) {
    for (std::size_t i = 0; i < table->scenes.size(); ++i) {
      if (halves.at(table->scenes[i]) == half) rows.emplace_back(table, i);
    }
  }
  HalfSample sample;
  sample.features.resize(static_cast<Eigen::Index>(rows.size()), first.features.cols());
  sample.labels.resize(static_cast<Eigen::Index>(rows.size()));
  for (Eigen::Index row = 0; row < sample.labels.size(); ++row) {
    const auto& [table, index] = rows[static_cast<std::size_t>(row)];
    sample.features.row(row) = table->features.row(index);
    sample.labels[row] = table == &first ? 1.0 : 0.0;
  }
  return sample;
}

/// Scenes of both, of the first alone and of the second alone, halved each by themselves.
SceneHalves halveScenes(const FeatureTable& first, const FeatureTable& second,
                        std::mt19937_64& generator) {
  const std::set<std::string> of_first(first.scenes.begin(), first.scenes.end());
  const std::set<std::string> of_second(second.scenes.begin(), second.scenes.end());
  std::vector<std::string> both, first_alone, second_alone;
  for (const std::string& scene : of_first) {
    (of_second.count(scene) > 0 ? both : first_alone).push_back(scene);
  }
  for (const std::string& scene : of_second) {
    if (of_first.count(scene) == 0) second_alone.push_back(scene);
  }
  SceneHalves halves = drawSceneHalves(both, generator);
  halves.merge(drawSceneHalves(first_alone, generator));
  halves.merge(drawSceneHalves(second_alone, generator));
  return halves;
}

}  // namespace

double areaUnderCurve(const std::vector<double>& positives, const std::vector<double>& negatives) {
  if (positives.empty() || negatives.empty()) {
    throw std::invalid_argument("no area under the curve without scores of both labels");
  }
  return wonPairs(positives, negatives) / pairCount(positives.size(), negatives.size());
}

double areaStandardError(std::size_t positives, std::size_t negatives) {
  return std::sqrt(wonVariance(positives, negatives)) / pairCount(positives, negatives);
}

LogisticRegression::LogisticRegression(const Eigen::MatrixXd& features,
                                       const Eigen::VectorXd& labels, double ridge)
    : mean_(features.colwise().mean()) {
  constexpr int kMostSteps = 50;
  constexpr double kConverged = 1e-9;  // change of the loss, per row
  const Eigen::RowVectorXd deviation =
      ((features.rowwise() - mean_).colwise().squaredNorm() / static_cast<double>(features.rows()))
          .cwiseSqrt();
  scale_ = (deviation.array() > 0.0).select(1.0 / deviation.array(), 0.0);
  const Eigen::MatrixXd design = standardised(features, mean_, scale_);
  Eigen::VectorXd penalty = Eigen::VectorXd::Constant(design.cols(), ridge);
  penalty[0] = 0.0;
  const auto lossOf = [&](const Eigen::VectorXd& weights) {
    const Eigen::ArrayXd log_odds = (design * weights).array();
    // log(1 + exp(x)) - label x, without overflow
    const double loss = (log_odds.max(0.0) + (1.0 + (-log_odds.abs()).exp()).log()).sum() -
                        labels.dot(log_odds.matrix());
    return loss + 0.5 * (penalty.array() * weights.array().square()).sum();
  };
  weights_ = Eigen::VectorXd::Zero(design.cols());
  double loss = lossOf(weights_);
  for (int step = 0; step < kMostSteps; ++step) {
    const Eigen::VectorXd odds = sigmoid(design * weights_);
    const Eigen::VectorXd slope =
        design.transpose() * (labels - odds) - penalty.cwiseProduct(weights_);
    Eigen::MatrixXd curvature =
        design.transpose() * (odds.array() * (1.0 - odds.array())).matrix().asDiagonal() * design;
    curvature += penalty.asDiagonal();
    Eigen::VectorXd change = curvature.ldlt().solve(slope);
    double next = lossOf(weights_ + change);
    // Far from the optimum Newton's step can overshoot.
    while (!(next <= loss) && change.norm() > kConverged) {
      change *= 0.5;
      next = lossOf(weights_ + change);
    }
    if (!(next <= loss)) return;
    weights_ += change;
    if (loss - next < kConverged * static_cast<double>(features.rows())) return;
    loss = next;
  }
}

Eigen::VectorXd LogisticRegression::scores(const Eigen::MatrixXd& features) const {
  return standardised(features, mean_, scale_) * weights_;
}

/// Grows trees on one training sample.
class BoostedForest::Grower {
 public:
  Grower(const Eigen::MatrixXd& features, const ForestOptions& options)
      : features_(features), options_(options), side_(static_cast<std::size_t>(features.rows())) {
    for (Eigen::Index feature = 0; feature < features.cols(); ++feature) {
      std::vector<Eigen::Index> order(static_cast<std::size_t>(features.rows()));
      std::iota(order.begin(), order.end(), Eigen::Index{0});
      std::stable_sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
        return features(a, feature) < features(b, feature);
      });
      orders_.push_back(std::move(order));
    }
  }

  /// The tree that lowers the loss most, split by split. `gradients` and `curvatures` are the first
  /// and the second derivatives of each row's loss by its score.
  Tree grow(const Eigen::VectorXd& gradients, const Eigen::VectorXd& curvatures) {
    std::fill(side_.begin(), side_.end(), 0);
    Tree tree;
    tree.root = bestSplit(0, gradients, curvatures);
    for (Eigen::Index row = 0; row < features_.rows(); ++row) {
      side_[static_cast<std::size_t>(row)] =
          features_(row, tree.root.feature) <= tree.root.threshold ? 0 : 1;
    }
    for (int side = 0; side < 2; ++side) {
      tree.sides[side] = bestSplit(side, gradients, curvatures);
      setLeaves(tree, side, gradients, curvatures);
    }
    return tree;
  }

 private:
  struct Sums {
    double gradient = 0.0;
    double curvature = 0.0;
    int rows = 0;

    void add(double more_gradient, double more_curvature) {
      gradient += more_gradient;
      curvature += more_curvature;
      ++rows;
    }
  };

  double gainOf(const Sums& sums) const {
    return sums.gradient * sums.gradient / (sums.curvature + options_.leaf_ridge);
  }

  Sums sumsOf(int side, const Eigen::VectorXd& gradients, const Eigen::VectorXd& curvatures) const {
    Sums sums;
    for (Eigen::Index row = 0; row < features_.rows(); ++row) {
      if (side_[static_cast<std::size_t>(row)] == side) sums.add(gradients[row], curvatures[row]);
    }
    return sums;
  }

  /// Of the rows of a side. All of them go to the first side where none is worth a split.
  Split bestSplit(int side, const Eigen::VectorXd& gradients,
                  const Eigen::VectorXd& curvatures) const {
    const Sums all = sumsOf(side, gradients, curvatures);
    Split best{0, std::numeric_limits<double>::infinity()};
    double best_gain = gainOf(all);
    for (Eigen::Index feature = 0; feature < features_.cols(); ++feature) {
      Sums below;
      double previous = 0.0;
      for (const Eigen::Index row : orders_[static_cast<std::size_t>(feature)]) {
        if (side_[static_cast<std::size_t>(row)] != side) continue;
        const double value = features_(row, feature);
        if (below.rows >= options_.min_leaf && all.rows - below.rows >= options_.min_leaf &&
            value > previous) {
          const Sums above{all.gradient - below.gradient, all.curvature - below.curvature,
                           all.rows - below.rows};
          const double gain = gainOf(below) + gainOf(above);
          if (gain > best_gain) {
            best_gain = gain;
            best = {feature, previous + 0.5 * (value - previous)};
          }
        }
        below.add(gradients[row], curvatures[row]);
        previous = value;
      }
    }
    return best;
  }

  void setLeaves(Tree& tree, int side, const Eigen::VectorXd& gradients,
                 const Eigen::VectorXd& curvatures) const {
    Sums sums[2];
    const Split& split = tree.sides[side];
    for (Eigen::Index row = 0; row < features_.rows(); ++row) {
      if (side_[static_cast<std::size_t>(row)] != side) continue;
      sums[features_(row, split.feature) <= split.threshold ? 0 : 1].add(gradients[row],
                                                                         curvatures[row]);
    }
    for (int leaf = 0; leaf < 2; ++leaf) {
      tree.leaves[side][leaf] = -options_.learning_rate * sums[leaf].gradient /
                                (sums[leaf].curvature + options_.leaf_ridge);
    }
  }

  const Eigen::MatrixXd& features_;
  const ForestOptions& options_;
  std::vector<std::vector<Eigen::Index>> orders_;  // rows by rising value, for each feature
  std::vector<int> side_;                          // of the root, for each row
};

BoostedForest::BoostedForest(const Eigen::MatrixXd& features, const Eigen::VectorXd& labels,
                             const ForestOptions& options) {
  const double share = labels.mean();
  constant_ = std::log(share / (1.0 - share));
  Eigen::VectorXd log_odds = Eigen::VectorXd::Constant(labels.size(), constant_);
  Grower grower(features, options);
  for (int round = 0; round < options.rounds; ++round) {
    const Eigen::VectorXd odds = sigmoid(log_odds);
    const Tree tree = grower.grow(odds - labels, (odds.array() * (1.0 - odds.array())).matrix());
    for (Eigen::Index row = 0; row < features.rows(); ++row) {
      log_odds[row] += scoreOf(tree, features, row);
    }
    trees_.push_back(tree);
  }
}

double BoostedForest::scoreOf(const Tree& tree, const Eigen::MatrixXd& features, Eigen::Index row) {
  const int side = features(row, tree.root.feature) <= tree.root.threshold ? 0 : 1;
  const Split& split = tree.sides[side];
  return tree.leaves[side][features(row, split.feature) <= split.threshold ? 0 : 1];
}

Eigen::VectorXd BoostedForest::scores(const Eigen::MatrixXd& features) const {
  Eigen::VectorXd scores = Eigen::VectorXd::Constant(features.rows(), constant_);
  for (const Tree& tree : trees_) {
    for (Eigen::Index row = 0; row < features.rows(); ++row) {
      scores[row] += scoreOf(tree, features, row);
    }
  }
  return scores;
}

std::optional<TwoSampleTest> testTwoSamples(const FeatureTable& first, const FeatureTable& second,
                                            const ClassifierOptions& options, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  const SceneHalves halves = halveScenes(first, second, generator);
  const std::array<HalfSample, 2> samples = {halfOf(first, second, halves, 0),
                                             halfOf(first, second, halves, 1)};
  if (!samples[0].hasBoth() || !samples[1].hasBoth()) return std::nullopt;
  double pairs = 0.0;
  double variance = 0.0;
  TwoSampleTest test{0.0, 0.0, 0.0, first.scenes.size(), second.scenes.size()};
  for (const int trained : {0, 1}) {
    const HalfSample& training = samples[static_cast<std::size_t>(trained)];
    const HalfSample& tested = samples[static_cast<std::size_t>(1 - trained)];
    const auto won = [&](const Eigen::VectorXd& scores) {
      return wonPairs(tested.ofLabel(scores, 1.0), tested.ofLabel(scores, 0.0));
    };
    test.logistic += won(LogisticRegression(training.features, training.labels, options.ridge)
                             .scores(tested.features));
    test.forest += won(
        BoostedForest(training.features, training.labels, options.forest).scores(tested.features));
    const auto positives = static_cast<std::size_t>(tested.labels.sum());
    const auto negatives = static_cast<std::size_t>(tested.labels.size()) - positives;
    pairs += pairCount(positives, negatives);
    variance += wonVariance(positives, negatives);
  }
  test.logistic /= pairs;
  test.forest /= pairs;
  test.standard_error = std::sqrt(variance) / pairs;
  return test;
}

}  // namespace forge
