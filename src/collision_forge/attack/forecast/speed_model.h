#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "collision_forge/attack/forecast/folds.h"
#include "collision_forge/attack/forecast/speed_forecaster.h"

namespace forge {

/// Weighted profiles over the next intervals of kProfileStep, in m/s or in multiples of a spread.
struct WeightedProfiles {
  Eigen::MatrixXd profiles;  ///< row: profile, column: interval
  Eigen::VectorXd weights;   ///< one per profile, sum 1
};

/// Parameters of a SpeedModel. Scaled features are featuresOf() times `feature_weights`, clamped to
/// `lowest` and `highest`, the range of the training data. The basis vector is [1, scaled features,
/// and per centre 1 / sqrt(1 + squared distance to the scaled features)]. A column of a forecast is
/// an interval of kProfileStep from t0 on.
struct SpeedModelWeights {
  std::vector<std::string> left_out_scenes;  ///< names of the scenes not used in the fit
  Eigen::RowVectorXd feature_weights;        ///< factor per feature
  Eigen::RowVectorXd lowest;                 ///< minimum of the scaled features
  Eigen::RowVectorXd highest;                ///< maximum of the scaled features
  Eigen::MatrixXd centers;                   ///< row: centre, in scaled features
  Eigen::MatrixXd gains;  ///< basis * gains: expected speed minus speed at t0, m/s, per interval
  /// basis * log_spreads: log of the mean |error| (m/s), per interval
  Eigen::MatrixXd log_spreads;
  /// errors of the expected speeds, in multiples of exp(basis * log_spreads)
  WeightedProfiles residuals;
  /// m/s; an ego whose mean speed over the last kProfileStep is lower stands
  double standing_speed = 0.0;
  /// row: profile of an ego that stands at t0, m/s above its speed at t0, column: interval; no rows
  /// if too few were recorded
  Eigen::MatrixXd standing;
  /// [1, scaled features] * standing_shares: weight of each `standing` profile, negative values
  /// count as zero (1e-6). Without columns a standing ego is forecast like a moving one.
  Eigen::MatrixXd standing_shares;
};

/// Throws std::invalid_argument, naming the field, if sizes do not match, a number is not finite or
/// too large, or profile weights are negative or do not sum to 1.
void checkWeights(const SpeedModelWeights& weights);

/// Returns the basis vectors of situations, one row each. `features`: one row of featuresOf() per
/// situation.
Eigen::MatrixXd basisOf(const Eigen::ArrayXXd& features, const SpeedModelWeights& weights);

/// Forecasts by a regression fitted to recorded profiles (fitSpeedModel()); the profiles are not
/// needed any more. A forecast has at most as many columns as SpeedModelWeights::gains.
class SpeedModel : public SpeedForecaster {
 public:
  /// `folds`: models fitted without some scenes each. Throws std::invalid_argument if two folds
  /// leave out the same scene, and as checkWeights().
  explicit SpeedModel(SpeedModelWeights weights, std::vector<SpeedModelWeights> folds = {});

  /// Returns the weights of the model itself, not of a fold.
  const SpeedModelWeights& weights() const { return weights_; }
  /// Returns the models fitted without some scenes, in the order of the constructor.
  const std::vector<std::shared_ptr<const SpeedModel>>& folds() const { return folds_.models(); }

  SpeedForecast forecast(const DrivingSituation& situation, int intervals) const override;
  std::shared_ptr<const SpeedForecaster> withoutScene(const std::string& scene) const override {
    return folds_.withoutScene(scene);
  }

 private:
  SpeedModelWeights weights_;
  Folds<SpeedModel> folds_;
};

}  // namespace forge
