#pragma once

#include <array>
#include <memory>
#include <random>
#include <vector>

#include "collision_forge/attack/forecast/ego_paths.h"
#include "collision_forge/attack/forecast/options.h"
#include "collision_forge/attack/forecast/speed_forecaster.h"
#include "collision_forge/base/scene/track.h"

namespace forge {

/// share 0..1 of the ego's lateral offset from the path at t0 that stays
inline constexpr double kKeptOffset = 0.3;

/// s after t0; a reversing ego that brakes has stopped by then. Chosen, not fitted: recordings have
/// too few reversing egos.
inline constexpr double kReverseStop = 8.0;

// Parts of the samplers of the ego's futures.

/// Stratified random numbers in (0, 1): equally spaced, with one random shift.
class EvenDraws {
 public:
  /// Draws the shift from `engine`. `count`: number of draws, positive.
  EvenDraws(int count, std::mt19937_64& engine)
      : count_(count), shift_((static_cast<double>(engine() >> 11) + 0.5) * 0x1.0p-53) {}
  /// Returns the i-th number, 0 <= i < count; ascending.
  double operator()(int i) const { return (i + shift_) / count_; }

 private:
  double count_;
  double shift_;
};

/// Returns `count` stratified samples of a zero-mean Laplace distribution with mean absolute value
/// `mean_difference` (its unit is the unit of the samples), in random order; none if `count` is 0.
std::vector<double> drawDifferences(int count, double mean_difference, std::mt19937_64& engine);

/// Distributes `count` samples over choices: returns the number of samples per choice, in the order
/// of `weights`, whose sum is `count`. Each number is `count` times the weight, rounded up or down
/// at random. `weights` must not be empty and must sum to 1.
std::vector<int> shareOut(const std::vector<double>& weights, int count, std::mt19937_64& engine);

/// Returns the forecast of `speeds` for the next `horizon` s, rounded up to whole kProfileStep; its
/// columns may cover less. If `speeds` is null or its forecast has no columns, returns 64 equally
/// weighted profiles over the whole horizon in which the mean acceleration over the last 1 s, with
/// the spread of EgoFutureOptions, decays; speeds stay at or above 0. Throws as
/// SpeedForecaster::forecast().
SpeedForecast forecastSpeeds(const SpeedForecaster* speeds, const DrivingSituation& situation,
                             double horizon, const EgoFutureOptions& options);

/// Returns the indices of `count` rows of the forecast, drawn by weight and stratified by the
/// distance driven in 4 s (or in all columns, if they cover less), shortest first; a row may appear
/// several times. The forecast must have a row.
std::vector<Eigen::Index> drawProfiles(const SpeedForecast& forecast, int count,
                                       std::mt19937_64& engine);

/// Distance driven since t0 as a smooth, non-decreasing function of time, from mean speeds over
/// intervals of kProfileStep.
class DrivenDistance {
 public:
  /// `past_speed`: mean speed over the interval before t0, m/s; a negative one counts as 0.
  /// `speeds`: mean speed of each interval from t0 on, m/s, >= 0; if empty, `past_speed` continues.
  /// Between the intervals' ends a monotone cubic (Hermite) interpolates.
  DrivenDistance(double past_speed, const Eigen::RowVectorXd& speeds);

  /// Returns the distance (m) at `time` s after t0; `time` must not be negative. Beyond the last
  /// interval its speed continues.
  double at(double time) const;

 private:
  struct Node {
    double distance;
    double speed;
  };
  std::vector<Node> nodes_;
};

/// Poses that converge from the ego's pose to a lateral offset from the path, critically damped.
/// The target offset is kKeptOffset times the offset at t0 plus `offset_difference` (m, left
/// positive). `path` must outlive this object.
class ReturnToPath {
 public:
  /// Keeps a reference to `path`. The offset falls to about 1/e in the distance that the ego drives
  /// in 1.1 s, at least 5 m; the heading at t0 must be within 90 degrees of the path's start.
  ReturnToPath(const SampledPath& path, const EgoNow& ego, double offset_difference);

  /// Returns the box centre (map frame) after `driven` m along the path from the ego's place at t0.
  Pose2 poseAfter(double driven) const;

 private:
  const SampledPath& path_;
  double start_ = 0.0;
  double target_ = 0.0;
  double lateral_ = 0.0;
  double slope_ = 0.0;
  double rate_ = 0.0;
  double return_distance_ = 0.0;
};

/// Returns the ego's track (box centres) along `way` for `horizon` s, one state per `step` (s), the
/// first at t0: `now.state`, the last at the first multiple of `step` at or after `horizon`. The
/// track has the id, class and size of `ego`. Velocities are derived from the poses.
Track drive(const Track& ego, const EgoNow& now, const DrivenDistance& distance,
            const ReturnToPath& way, double horizon, double step);

/// Returns true if the ego's mean speed over the last kProfileStep is backwards and above
/// kStandstillSpeed.
bool isReversing(const EgoNow& ego);

/// Returns `count` equally likely tracks of a reversing ego: about half of them continue to reverse
/// with the acceleration at t0, which decays, the others brake to a standstill at times spread
/// evenly over kReverseStop. The turn rate at t0 decays. `options` holds the spreads of both.
/// Sorted by the distance driven in 4 s, shortest first; `ego` gives id, class and size. States are
/// kPredictionStep apart from t0 to at least `horizon` s later.
std::vector<Track> reversingFutures(const Track& ego, const EgoNow& now, double horizon, int count,
                                    const EgoFutureOptions& options, std::mt19937_64& engine);

/// Throws std::invalid_argument if `horizon` (s) is not positive and finite or `count` is negative.
void checkSampleArguments(double horizon, int count);

}  // namespace forge
