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

inline constexpr double kKeptOffset = 0.3;  ///< share of an offset from the path that stays

// What samplers of the ego's futures are made of.

/// Evenly spread numbers in (0, 1), shifted at random.
class EvenDraws {
 public:
  EvenDraws(int count, std::mt19937_64& engine)
      : count_(count), shift_((static_cast<double>(engine() >> 11) + 0.5) * 0x1.0p-53) {}
  double operator()(int i) const { return (i + shift_) / count_; }

 private:
  double count_;
  double shift_;
};

/// Evenly spread differences of a two-sided exponential (Laplace) distribution, in random order.
std::vector<double> drawDifferences(int count, double mean_difference, std::mt19937_64& engine);

/// How many of `count` samples each of some choices gets. Weights sum to 1.
std::vector<int> shareOut(const std::vector<double>& weights, int count, std::mt19937_64& engine);

/// What `speeds` foretells for the next `horizon` seconds; the present acceleration, with a spread,
/// fades where it is null or knows nothing.
SpeedForecast forecastSpeeds(const SpeedForecaster* speeds, const DrivingSituation& situation,
                             double horizon, const EgoFutureOptions& options);

/// Rows of the forecast, spread evenly by the distance that they drive in 4 s.
std::vector<Eigen::Index> drawProfiles(const SpeedForecast& forecast, int count,
                                       std::mt19937_64& engine);

/// Distance driven since now, smooth and never falling, from the mean speeds of intervals of
/// kProfileStep.
class DrivenDistance {
 public:
  DrivenDistance(double past_speed, const Eigen::RowVectorXd& speeds);

  /// Metres. Beyond the last interval its speed is kept.
  double at(double time) const;

 private:
  struct Node {
    double distance;
    double speed;
  };
  std::vector<Node> nodes_;
};

/// Poses that leave the ego's for a path: critically damped towards a lateral offset from it, which
/// is a share of the present one and `offset_difference` (metres) more. The path must outlive it.
class ReturnToPath {
 public:
  ReturnToPath(const SampledPath& path, const EgoNow& ego, double offset_difference);

  /// After so many metres along the path.
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

/// The ego on its way for `horizon` seconds, a state each `step`; the first is now's.
Track drive(const Track& ego, const EgoNow& now, const DrivenDistance& distance,
            const ReturnToPath& way, double horizon, double step);

/// Throws std::invalid_argument for a horizon that is not positive and finite and a negative count.
void checkSampleArguments(double horizon, int count);

}  // namespace forge
