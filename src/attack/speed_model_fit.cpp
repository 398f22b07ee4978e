#include "attack/speed_model_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>
#include <utility>

#include "attack/speed_clusters.h"

namespace forge {
namespace {

constexpr Eigen::Index kMinProfiles = 40;  // that an interval is fitted on
constexpr Eigen::Index kRowsACenter = 8;   // a small collection is not learnt by heart
constexpr Eigen::Index kMinStanding = 8;   // profiles that begin at a standstill
constexpr double kMinSpread = 1e-3;        // m/s, of drivers who are all alike
constexpr double kConstantRidge = 1e-6;    // of the constant, which is not drawn to zero

/// A fold from 0 to folds - 1 for each item, at random, of even sizes.
std::vector<int> deal(std::size_t count, int folds, std::uint64_t seed) {
  std::vector<int> fold(count);
  for (std::size_t i = 0; i < count; ++i) {
    fold[i] = static_cast<int>(i % static_cast<std::size_t>(folds));
  }
  std::mt19937_64 engine(seed);
  for (std::size_t i = count; i > 1; --i) std::swap(fold[i - 1], fold[engine() % i]);
  return fold;
}

/// The rows that a model is fitted to, those that last longest first.
class Sample {
 public:
  Sample(const SpeedSituations& recorded, const std::vector<std::string>& left_out_scenes,
         const SpeedModelFitOptions& options)
      : recorded_(recorded) {
    std::vector<bool> left_out(recorded.scenes().size(), false);
    for (const std::string& name : left_out_scenes) {
      const int scene = recorded.sceneNumber(name);
      if (scene >= 0) left_out[static_cast<std::size_t>(scene)] = true;
    }
    for (Eigen::Index row = 0; row < recorded.size(); ++row) {
      if (recorded.lasts(row) == 0 || left_out[static_cast<std::size_t>(recorded.sceneOf(row))]) {
        continue;
      }
      rows_.push_back(row);
    }
    std::stable_sort(rows_.begin(), rows_.end(), [&](Eigen::Index a, Eigen::Index b) {
      return recorded.lasts(a) > recorded.lasts(b);
    });
    intervals_ = options.intervals;
    while (intervals_ > 0 && lasting(intervals_ - 1) < kMinProfiles) --intervals_;
    if (intervals_ == 0) {
      throw std::invalid_argument(std::to_string(rows_.size()) +
                                  " speed profiles are too few to fit a model; it takes " +
                                  std::to_string(kMinProfiles));
    }
  }

  Eigen::Index size() const { return static_cast<Eigen::Index>(rows_.size()); }
  int intervals() const { return intervals_; }
  Eigen::Index row(Eigen::Index i) const { return rows_[static_cast<std::size_t>(i)]; }
  double speed(Eigen::Index i) const { return recorded_.speed(row(i)); }
  int sceneOf(Eigen::Index i) const { return recorded_.sceneOf(row(i)); }

  /// How many of the rows, the first ones, have the interval recorded.
  Eigen::Index lasting(int interval) const {
    return std::partition_point(rows_.begin(), rows_.end(),
                                [&](Eigen::Index row) { return recorded_.lasts(row) > interval; }) -
           rows_.begin();
  }

  /// Of the rows that have the interval recorded.
  Eigen::VectorXd gains(int interval) const {
    Eigen::VectorXd gains(lasting(interval));
    for (Eigen::Index i = 0; i < gains.size(); ++i) gains[i] = recorded_.gain(row(i), interval);
    return gains;
  }

  /// Over all intervals, of a row that lasts so long.
  Eigen::RowVectorXd gainsOf(Eigen::Index i) const {
    Eigen::RowVectorXd gains(intervals_);
    for (int interval = 0; interval < intervals_; ++interval) {
      gains[interval] = recorded_.gain(row(i), interval);
    }
    return gains;
  }

  Eigen::ArrayXXd features() const {
    Eigen::ArrayXXd features(size(), kSpeedFeatures);
    for (Eigen::Index i = 0; i < size(); ++i) features.row(i) = recorded_.features().row(row(i));
    return features;
  }

 private:
  const SpeedSituations& recorded_;
  std::vector<Eigen::Index> rows_;
  int intervals_ = 0;
};

/// Sums over rows that ridge regressions on the basis are solved from, for each fold apart.
class NormalEquations {
 public:
  NormalEquations(const Eigen::MatrixXd& basis, const std::vector<int>& fold_of, int folds,
                  double linear_ridge)
      : basis_(basis),
        fold_of_(fold_of),
        products_(static_cast<std::size_t>(folds),
                  Eigen::MatrixXd::Zero(basis.cols(), basis.cols())),
        linear_ridge_(linear_ridge) {}

  /// Takes the rows up to `count` in.
  void extend(Eigen::Index count) {
    for (std::size_t fold = 0; fold < products_.size(); ++fold) {
      const std::vector<Eigen::Index> rows = rowsOf(fold, count_, count);
      Eigen::MatrixXd part(static_cast<Eigen::Index>(rows.size()), basis_.cols());
      for (std::size_t i = 0; i < rows.size(); ++i) {
        part.row(static_cast<Eigen::Index>(i)) = basis_.row(rows[i]);
      }
      products_[fold].selfadjointView<Eigen::Lower>().rankUpdate(part.transpose());
    }
    count_ = count;
  }

  /// Coefficients that fit `values`, one a row taken in, without the rows of `left_out` (-1: none).
  Eigen::VectorXd solve(const Eigen::VectorXd& values, double ridge, int left_out = -1) const {
    Eigen::MatrixXd product = Eigen::MatrixXd::Zero(basis_.cols(), basis_.cols());
    for (std::size_t fold = 0; fold < products_.size(); ++fold) {
      if (static_cast<int>(fold) != left_out) product += products_[fold];
    }
    Eigen::VectorXd kept = values;
    for (Eigen::Index i = 0; i < kept.size(); ++i) {
      if (fold_of_[static_cast<std::size_t>(i)] == left_out) kept[i] = 0.0;
    }
    product.diagonal().array() += ridge;
    product.diagonal().segment(1, kSpeedFeatures).array() += linear_ridge_ - ridge;
    product(0, 0) += kConstantRidge - ridge;
    const Eigen::VectorXd right = basis_.topRows(count_).transpose() * kept;
    return product.selfadjointView<Eigen::Lower>().ldlt().solve(right);
  }

  /// `values` less what is fitted to the rows of other folds.
  Eigen::VectorXd heldOutResiduals(const Eigen::VectorXd& values, double ridge) const {
    Eigen::VectorXd residuals = values;
    for (std::size_t fold = 0; fold < products_.size(); ++fold) {
      const Eigen::VectorXd coefficients = solve(values, ridge, static_cast<int>(fold));
      for (const Eigen::Index row : rowsOf(fold, 0, count_)) {
        residuals[row] -= basis_.row(row) * coefficients;
      }
    }
    return residuals;
  }

 private:
  std::vector<Eigen::Index> rowsOf(std::size_t fold, Eigen::Index begin, Eigen::Index end) const {
    std::vector<Eigen::Index> rows;
    for (Eigen::Index i = begin; i < end; ++i) {
      if (fold_of_[static_cast<std::size_t>(i)] == static_cast<int>(fold)) rows.push_back(i);
    }
    return rows;
  }

  const Eigen::MatrixXd& basis_;
  const std::vector<int>& fold_of_;
  std::vector<Eigen::MatrixXd> products_;
  double linear_ridge_;
  Eigen::Index count_ = 0;
};

/// Folds of whole scenes, one for each row of the sample, and their number.
std::pair<std::vector<int>, int> foldsByScene(const Sample& sample, int wanted,
                                              std::uint64_t seed) {
  std::vector<int> scenes;
  for (Eigen::Index i = 0; i < sample.size(); ++i) scenes.push_back(sample.sceneOf(i));
  std::vector<int> distinct = scenes;
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  if (distinct.size() < 2) {
    throw std::invalid_argument("speed profiles of one scene are too few to fit a model");
  }
  const int folds = std::min(wanted, static_cast<int>(distinct.size()));
  const std::vector<int> fold = deal(distinct.size(), folds, seed);
  for (int& scene : scenes) {
    const auto place = std::lower_bound(distinct.begin(), distinct.end(), scene);
    scene = fold[static_cast<std::size_t>(place - distinct.begin())];
  }
  return {scenes, folds};
}

void placeCenters(const Sample& sample, const SpeedModelFitOptions& options, std::uint64_t seed,
                  SpeedModelWeights& weights) {
  weights.feature_weights =
      Eigen::Map<const Eigen::RowVectorXd>(options.feature_weights.data(), kSpeedFeatures);
  const Eigen::MatrixXd scaled =
      (sample.features().rowwise() * weights.feature_weights.array()).matrix();
  weights.lowest = scaled.colwise().minCoeff();
  weights.highest = scaled.colwise().maxCoeff();
  const auto count = std::min<Eigen::Index>(options.centers, sample.size() / kRowsACenter);
  weights.centers =
      clusterPoints(scaled, static_cast<int>(count), options.cluster_rounds, seed).centers;
}

/// Fits gains and log_spreads. Returns the residuals, in spreads; a row a row of the sample, zero
/// where a profile has ended.
Eigen::MatrixXd fitRegressions(const Sample& sample, const SpeedModelFitOptions& options,
                               std::uint64_t seed, SpeedModelWeights& weights) {
  const Eigen::MatrixXd basis = basisOf(sample.features(), weights);
  const auto [fold_of, folds] = foldsByScene(sample, options.folds, seed);
  NormalEquations equations(basis, fold_of, folds, options.linear_ridge);
  weights.gains.resize(basis.cols(), sample.intervals());
  weights.log_spreads.resize(basis.cols(), sample.intervals());
  Eigen::MatrixXd residuals = Eigen::MatrixXd::Zero(sample.size(), sample.intervals());
  for (int interval = sample.intervals() - 1; interval >= 0; --interval) {
    const Eigen::Index count = sample.lasting(interval);
    equations.extend(count);
    const Eigen::VectorXd gains = sample.gains(interval);
    weights.gains.col(interval) = equations.solve(gains, options.gain_ridge);
    const Eigen::VectorXd differences = equations.heldOutResiduals(gains, options.gain_ridge);
    const double floor = options.spread_floor * differences.cwiseAbs().mean() + kMinSpread;
    const Eigen::VectorXd log_spreads = (differences.array().abs() + floor).log();
    weights.log_spreads.col(interval) = equations.solve(log_spreads, options.spread_ridge);
    const Eigen::VectorXd spreads =
        (basis.topRows(count) * weights.log_spreads.col(interval)).array().exp();
    residuals.col(interval).head(count) = differences.cwiseQuotient(spreads);
  }
  return residuals;
}

/// Of the points, one a cluster.
Eigen::VectorXd sharesOf(const Clusters& clusters) {
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(clusters.centers.rows());
  for (const Eigen::Index cluster : clusters.member) shares[cluster] += 1.0;
  return shares / static_cast<double>(clusters.member.size());
}

/// A row a cluster.
Eigen::MatrixXd meansOf(const Eigen::MatrixXd& profiles, const Clusters& clusters) {
  Eigen::MatrixXd means = Eigen::MatrixXd::Zero(clusters.centers.rows(), profiles.cols());
  const Eigen::VectorXd shares = sharesOf(clusters);
  for (Eigen::Index i = 0; i < profiles.rows(); ++i) {
    means.row(clusters.member[static_cast<std::size_t>(i)]) += profiles.row(i);
  }
  means.array().colwise() /= static_cast<double>(profiles.rows()) * shares.array();
  return means;
}

/// Sums from the first column on.
Eigen::MatrixXd accumulated(Eigen::MatrixXd values) {
  for (Eigen::Index i = 1; i < values.cols(); ++i) values.col(i) += values.col(i - 1);
  return values;
}

/// Typical residuals, as far from zero as those that they stand for are.
WeightedProfiles typicalResiduals(const Sample& sample, const Eigen::MatrixXd& residuals,
                                  const SpeedModelFitOptions& options, std::uint64_t seed) {
  const int intervals = sample.intervals();
  const Eigen::MatrixXd whole = residuals.topRows(sample.lasting(intervals - 1));
  Eigen::MatrixXd driven = accumulated(whole);
  for (Eigen::Index i = 0; i < driven.cols(); ++i) {
    driven.col(i) /= std::max(driven.col(i).norm(), kMinSpread);
  }
  const Clusters clusters = clusterPoints(driven, options.profiles, options.cluster_rounds, seed);
  WeightedProfiles profiles{meansOf(whole, clusters), sharesOf(clusters)};
  for (int interval = 0; interval < intervals; ++interval) {
    const Eigen::Index count = sample.lasting(interval);
    const double wanted =
        residuals.col(interval).head(count).squaredNorm() / static_cast<double>(count);
    const double is = profiles.weights.dot(profiles.profiles.col(interval).cwiseAbs2());
    if (is > 0.0) profiles.profiles.col(interval) *= std::sqrt(wanted / is);
  }
  return profiles;
}

/// Regresses on the features which of the typical profiles a standing driver takes. `linear`: 1 and
/// the scaled features, a row a driver.
Eigen::MatrixXd fitShares(const Eigen::MatrixXd& linear, const Clusters& clusters,
                          const SpeedModelFitOptions& options) {
  Eigen::MatrixXd taken = Eigen::MatrixXd::Zero(linear.rows(), clusters.centers.rows());
  for (Eigen::Index i = 0; i < linear.rows(); ++i) {
    taken(i, clusters.member[static_cast<std::size_t>(i)]) = 1.0;
  }
  Eigen::MatrixXd product = linear.transpose() * linear;
  product.diagonal().array() += options.standing_ridge;
  product(0, 0) += kConstantRidge - options.standing_ridge;
  return product.ldlt().solve(linear.transpose() * taken);
}

/// Fits what follows a standstill; nothing when too little is recorded.
void fitStanding(const Sample& sample, const SpeedModelFitOptions& options, std::uint64_t seed,
                 SpeedModelWeights& weights) {
  const Eigen::MatrixXd basis = basisOf(sample.features(), weights);
  std::vector<Eigen::Index> standing;
  for (Eigen::Index i = 0; i < sample.lasting(sample.intervals() - 1); ++i) {
    if (sample.speed(i) < options.standing_speed) standing.push_back(i);
  }
  const auto count = static_cast<Eigen::Index>(standing.size());
  weights.standing_speed = options.standing_speed;
  weights.standing_shares.resize(1 + kSpeedFeatures, 0);
  if (count < kMinStanding) return;
  Eigen::MatrixXd gains(count, sample.intervals());
  Eigen::MatrixXd linear(count, 1 + kSpeedFeatures);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Index at = standing[static_cast<std::size_t>(i)];
    gains.row(i) = sample.gainsOf(at);
    linear.row(i) = basis.row(at).head(linear.cols());
  }
  const Clusters clusters =
      clusterPoints(accumulated(gains), options.standing_profiles, options.cluster_rounds, seed);
  weights.standing = meansOf(gains, clusters);
  weights.standing_shares = fitShares(linear, clusters, options);
}

}  // namespace

SpeedModelWeights fitSpeedModel(const SpeedSituations& recorded,
                                const std::vector<std::string>& left_out_scenes,
                                const SpeedModelFitOptions& options, std::uint64_t seed) {
  const Sample sample(recorded, left_out_scenes, options);
  SpeedModelWeights weights;
  weights.left_out_scenes = left_out_scenes;
  placeCenters(sample, options, seed, weights);
  const Eigen::MatrixXd residuals = fitRegressions(sample, options, seed, weights);
  weights.residuals = typicalResiduals(sample, residuals, options, seed);
  fitStanding(sample, options, seed, weights);
  return weights;
}

SpeedModel fitSpeedModelWithFolds(const SpeedSituations& recorded, int folds,
                                  const SpeedModelFitOptions& options, std::uint64_t seed) {
  if (folds < 0 || folds == 1 || folds > static_cast<int>(recorded.scenes().size())) {
    throw std::invalid_argument(std::to_string(folds) + " folds of " +
                                std::to_string(recorded.scenes().size()) +
                                " scenes: it takes none, or 2 to one a scene");
  }
  std::vector<std::vector<std::string>> left_out(static_cast<std::size_t>(folds));
  if (folds > 0) {
    const std::vector<int> fold = deal(recorded.scenes().size(), folds, seed);
    for (std::size_t i = 0; i < fold.size(); ++i) {
      left_out[static_cast<std::size_t>(fold[i])].push_back(recorded.scenes()[i]);
    }
  }
  std::vector<SpeedModelWeights> models;
  for (const auto& scenes : left_out) {
    models.push_back(fitSpeedModel(recorded, scenes, options, seed));
  }
  return SpeedModel(fitSpeedModel(recorded, {}, options, seed), std::move(models));
}

}  // namespace forge
