#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "collision_forge/attack/forecast/folds.h"
#include "collision_forge/attack/forecast/speed_forecaster.h"

namespace forge {

/// Speeds over the next intervals of kProfileStep, m/s, or multiples of a spread.
struct WeightedProfiles {
  Eigen::MatrixXd profiles;  ///< a row a profile, a column an interval
  Eigen::VectorXd weights;   ///< one a profile, sum 1
};

/// What a SpeedModel is made of. Scaled features are featuresOf() times `feature_weights`, held
/// within what the model was fitted to. The basis is 1, the scaled features, and for each center
/// 1 / sqrt(1 + squared distance from the scaled features).
struct SpeedModelWeights {
  std::vector<std::string> left_out_scenes;  ///< that the model was not fitted to
  Eigen::RowVectorXd feature_weights;
  Eigen::RowVectorXd lowest;        ///< scaled features
  Eigen::RowVectorXd highest;       ///< scaled features
  Eigen::MatrixXd centers;          ///< a row a center, scaled features
  Eigen::MatrixXd gains;            ///< times the basis: m/s expected over the present speed
  Eigen::MatrixXd log_spreads;      ///< times the basis: logarithm of the mean difference from that
  WeightedProfiles residuals;       ///< differences, in spreads
  double standing_speed = 0.0;      ///< m/s; what is slower stands
  Eigen::MatrixXd standing;         ///< profiles after a standstill, m/s over the present speed
  Eigen::MatrixXd standing_shares;  ///< times 1 and the scaled features: how likely each of them
                                    ///< is, none when negative; no columns: as driving
};

/// Throws std::invalid_argument, naming the field, when sizes do not fit together, a number is not
/// finite, or weights are negative or do not sum to 1.
void checkWeights(const SpeedModelWeights& weights);

/// The basis of the situations with these features (a row a situation).
Eigen::MatrixXd basisOf(const Eigen::ArrayXXd& features, const SpeedModelWeights& weights);

/// Forecasts by a regression that was fitted to recorded profiles (fitSpeedModel()), which it does
/// not need any more.
class SpeedModel : public SpeedForecaster {
 public:
  /// `folds` are models of the same drivers that left some scenes out each; no scene is left out
  /// twice. Throws std::invalid_argument otherwise and as checkWeights().
  explicit SpeedModel(SpeedModelWeights weights, std::vector<SpeedModelWeights> folds = {});

  const SpeedModelWeights& weights() const { return weights_; }
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
