#include "collision_forge/attack/forecast/speed_model_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>
#include <utility>

#include "collision_forge/attack/forecast/speed_clusters.h"

namespace forge {
namespace {

constexpr Eigen::Index kMinProfiles = 40;  // to fit an interval
constexpr Eigen::Index kRowsACenter = 8;   // rows per centre, against overfitting small collections
constexpr Eigen::Index kMinStanding = 8;   // profiles that begin at a standstill
constexpr double kMinSpread = 1e-3;        // m/s, for recordings without variation
constexpr double kConstantRidge = 1e-6;    // for the constant, which is hardly penalised

/// Assigns each item a random fold, 0 to folds - 1; fold sizes differ by at most one.
std::vector<int> deal(std::size_t count, int folds, std::uint64_t seed) {
  std::vector<int> fold(count);
  for (std::size_t i = 0; i < count; ++i) {
    fold[i] = static_cast<int>(i % static_cast<std::size_t>(folds));
  }
  std::mt19937_64 engine(seed);
  for (std::size_t i = count; i > 1; --i) std::swap(fold[i - 1], fold[engine() % i]);
  return fold;
}

/// Rows used in a fit, longest profiles first.
class Sample {
 public:
  Sample(const SpeedSituations& recorded, std::vector<Eigen::Index> rows)
      : recorded_(recorded), rows_(std::move(rows)) {
    std::stable_sort(rows_.begin(), rows_.end(), [&](Eigen::Index a, Eigen::Index b) {
      return recorded.intervalsAfter(a) > recorded.intervalsAfter(b);
    });
  }

  Eigen::Index size() const { return static_cast<Eigen::Index>(rows_.size()); }
  Eigen::Index row(Eigen::Index i) const { return rows_[static_cast<std::size_t>(i)]; }
  int sceneOf(Eigen::Index i) const { return recorded_.sceneOf(row(i)); }

  /// Returns the number of rows, all at the front, in which `interval` is recorded.
  Eigen::Index lasting(int interval) const {
    return std::partition_point(
               rows_.begin(), rows_.end(),
               [&](Eigen::Index row) { return recorded_.intervalsAfter(row) > interval; }) -
           rows_.begin();
  }

  /// Returns the gains at `interval` of the lasting(interval) rows.
  Eigen::VectorXd gains(int interval) const {
    Eigen::VectorXd gains(lasting(interval));
    for (Eigen::Index i = 0; i < gains.size(); ++i) gains[i] = recorded_.gain(row(i), interval);
    return gains;
  }

  /// Returns the gains of the rows in which the first `intervals` intervals are recorded, one row
  /// each.
  Eigen::MatrixXd wholeGains(int intervals) const {
    Eigen::MatrixXd whole(lasting(intervals - 1), intervals);
    for (int interval = 0; interval < intervals; ++interval) {
      whole.col(interval) = gains(interval).head(whole.rows());
    }
    return whole;
  }

  Eigen::ArrayXXd features() const {
    Eigen::ArrayXXd features(size(), kSpeedFeatures);
    for (Eigen::Index i = 0; i < size(); ++i) features.row(i) = recorded_.features().row(row(i));
    return features;
  }

 private:
  const SpeedSituations& recorded_;
  std::vector<Eigen::Index> rows_;
};

struct Samples {
  Sample driving;
  Sample standing;
  int intervals = 0;  ///< forecast intervals with enough recorded profiles
};

/// Throws std::invalid_argument if there are too few profiles.
Samples samplesOf(const SpeedSituations& recorded, const std::vector<std::string>& left_out_scenes,
                  const SpeedModelFitOptions& options) {
  std::vector<bool> left_out(recorded.scenes().size(), false);
  for (const std::string& name : left_out_scenes) {
    const int scene = recorded.sceneNumber(name);
    if (scene >= 0) left_out[static_cast<std::size_t>(scene)] = true;
  }
  std::vector<Eigen::Index> driving;
  std::vector<Eigen::Index> standing;
  for (Eigen::Index row = 0; row < recorded.size(); ++row) {
    const auto scene = static_cast<std::size_t>(recorded.sceneOf(row));
    if (recorded.intervalsAfter(row) == 0 || left_out[scene]) continue;
    (recorded.speed(row) < options.standing_speed ? standing : driving).push_back(row);
  }
  Samples samples{Sample(recorded, std::move(driving)), Sample(recorded, std::move(standing)),
                  options.intervals};
  int& intervals = samples.intervals;
  while (intervals > 0 && samples.driving.lasting(intervals - 1) < kMinProfiles) --intervals;
  if (intervals > 0) return samples;
  throw std::invalid_argument(
      std::to_string(samples.driving.size()) +
      " speed profiles of moving drivers are too few to fit a model; minimum " +
      std::to_string(kMinProfiles));
}

/// Normal equations of ridge regressions on the basis, summed per fold.
class NormalEquations {
 public:
  NormalEquations(const Eigen::MatrixXd& basis, const std::vector<int>& fold_of, int folds,
                  double linear_ridge)
      : basis_(basis),
        fold_of_(fold_of),
        products_(static_cast<std::size_t>(folds),
                  Eigen::MatrixXd::Zero(basis.cols(), basis.cols())),
        linear_ridge_(linear_ridge) {}

  /// Adds the rows up to `count`.
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

  /// Returns the coefficients that fit `values`, one per added row, without the rows of fold
  /// `left_out` (-1: all rows).
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

  /// Returns `values` minus their prediction by a fit to the other folds.
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

/// Returns the fold of each row, with whole scenes per fold, and the number of folds.
std::pair<std::vector<int>, int> foldsByScene(const Sample& sample, int wanted,
                                              std::uint64_t seed) {
  std::vector<int> scenes;
  for (Eigen::Index i = 0; i < sample.size(); ++i) scenes.push_back(sample.sceneOf(i));
  std::vector<int> distinct = scenes;
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  if (distinct.size() < 2) {
    throw std::invalid_argument(
        "speed profiles of one scene are too few to fit a model; minimum 2 scenes");
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

/// Fits gains and log_spreads. Returns the residuals in spreads, one row per sample row, zero after
/// the end of a profile.
Eigen::MatrixXd fitRegressions(const Sample& sample, int intervals,
                               const SpeedModelFitOptions& options, std::uint64_t seed,
                               SpeedModelWeights& weights) {
  const Eigen::MatrixXd basis = basisOf(sample.features(), weights);
  const auto [fold_of, folds] = foldsByScene(sample, options.folds, seed);
  NormalEquations equations(basis, fold_of, folds, options.linear_ridge);
  weights.gains.resize(basis.cols(), intervals);
  weights.log_spreads.resize(basis.cols(), intervals);
  Eigen::MatrixXd residuals = Eigen::MatrixXd::Zero(sample.size(), intervals);
  for (int interval = intervals - 1; interval >= 0; --interval) {
    const Eigen::Index count = sample.lasting(interval);
    equations.extend(count);
    const Eigen::VectorXd gains = sample.gains(interval);
    weights.gains.col(interval) = equations.solve(gains, options.gain_ridge);
    const Eigen::VectorXd missed = equations.heldOutResiduals(gains, options.gain_ridge);
    const double floor = options.spread_floor * missed.cwiseAbs().mean() + kMinSpread;
    const Eigen::VectorXd log_spreads = (missed.array().abs() + floor).log();
    weights.log_spreads.col(interval) = equations.solve(log_spreads, options.spread_ridge);
    const Eigen::VectorXd spreads =
        (log_spreads - equations.heldOutResiduals(log_spreads, options.spread_ridge)).array().exp();
    residuals.col(interval).head(count) = missed.cwiseQuotient(spreads);
  }
  return residuals;
}

/// Returns each cluster's share of the points.
Eigen::VectorXd sharesOf(const Clusters& clusters) {
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(clusters.centers.rows());
  for (const Eigen::Index cluster : clusters.member) shares[cluster] += 1.0;
  return shares / static_cast<double>(clusters.member.size());
}

/// Returns the mean profile of each cluster, one row each.
Eigen::MatrixXd meansOf(const Eigen::MatrixXd& profiles, const Clusters& clusters) {
  Eigen::MatrixXd means = Eigen::MatrixXd::Zero(clusters.centers.rows(), profiles.cols());
  const Eigen::VectorXd shares = sharesOf(clusters);
  for (Eigen::Index i = 0; i < profiles.rows(); ++i) {
    means.row(clusters.member[static_cast<std::size_t>(i)]) += profiles.row(i);
  }
  means.array().colwise() /= static_cast<double>(profiles.rows()) * shares.array();
  return means;
}

/// Returns the cumulative sums along each row.
Eigen::MatrixXd accumulated(Eigen::MatrixXd values) {
  for (Eigen::Index i = 1; i < values.cols(); ++i) values.col(i) += values.col(i - 1);
  return values;
}

/// Clusters the residuals of full-length profiles by their accumulated distance.
WeightedProfiles typicalResiduals(const Sample& sample, const Eigen::MatrixXd& residuals,
                                  const SpeedModelFitOptions& options, std::uint64_t seed) {
  const Eigen::MatrixXd whole =
      residuals.topRows(sample.lasting(static_cast<int>(residuals.cols()) - 1));
  const Eigen::MatrixXd driven = accumulated(whole);
  const Eigen::RowVectorXd scales = driven.colwise().norm().cwiseMax(kMinSpread).cwiseInverse();
  const Clusters clusters =
      clusterPoints(driven * scales.asDiagonal(), options.profiles, options.cluster_rounds, seed);
  return {meansOf(whole, clusters), sharesOf(clusters)};
}

/// Regresses the probability of each typical profile on the features. `linear`: [1, scaled
/// features], one row per driver.
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

/// Fits the profiles after a standstill; leaves them empty if too few are recorded.
void fitStanding(const Sample& sample, int intervals, const SpeedModelFitOptions& options,
                 std::uint64_t seed, SpeedModelWeights& weights) {
  weights.standing_speed = options.standing_speed;
  weights.standing_shares.resize(1 + kSpeedFeatures, 0);
  const Eigen::MatrixXd gains = sample.wholeGains(intervals);
  if (gains.rows() < kMinStanding) return;
  const Clusters clusters =
      clusterPoints(accumulated(gains), options.standing_profiles, options.cluster_rounds, seed);
  weights.standing = meansOf(gains, clusters);
  const Eigen::MatrixXd basis = basisOf(sample.features().topRows(gains.rows()), weights);
  weights.standing_shares = fitShares(basis.leftCols(1 + kSpeedFeatures), clusters, options);
}

}  // namespace

SpeedModelWeights fitSpeedModel(const SpeedSituations& recorded,
                                const std::vector<std::string>& left_out_scenes,
                                const SpeedModelFitOptions& options, std::uint64_t seed) {
  const Samples samples = samplesOf(recorded, left_out_scenes, options);
  SpeedModelWeights weights;
  weights.left_out_scenes = left_out_scenes;
  placeCenters(samples.driving, options, seed, weights);
  const Eigen::MatrixXd residuals =
      fitRegressions(samples.driving, samples.intervals, options, seed, weights);
  weights.residuals = typicalResiduals(samples.driving, residuals, options, seed);
  fitStanding(samples.standing, samples.intervals, options, seed, weights);
  return weights;
}

SpeedModel fitSpeedModelWithFolds(
    const SpeedSituations& recorded, int folds, const SpeedModelFitOptions& options,
    std::uint64_t seed, const std::function<void(std::size_t done, std::size_t all)>& on_progress) {
  if (folds < 0 || folds == 1 || folds > static_cast<int>(recorded.scenes().size())) {
    throw std::invalid_argument(std::to_string(folds) + " folds of " +
                                std::to_string(recorded.scenes().size()) +
                                " scenes: use 0, or 2 to the number of scenes");
  }
  std::vector<std::vector<std::string>> left_out(static_cast<std::size_t>(folds));
  if (folds > 0) {
    const std::vector<int> fold = deal(recorded.scenes().size(), folds, seed);
    for (std::size_t i = 0; i < fold.size(); ++i) {
      left_out[static_cast<std::size_t>(fold[i])].push_back(recorded.scenes()[i]);
    }
  }
  left_out.emplace_back();  // the model of all scenes
  std::vector<SpeedModelWeights> models;
  for (const auto& scenes : left_out) {
    models.push_back(fitSpeedModel(recorded, scenes, options, seed));
    if (on_progress) on_progress(models.size(), left_out.size());
  }
  SpeedModelWeights of_all = std::move(models.back());
  models.pop_back();
  return SpeedModel(std::move(of_all), std::move(models));
}

}  // namespace forge
