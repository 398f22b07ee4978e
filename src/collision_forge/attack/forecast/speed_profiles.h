#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "collision_forge/attack/forecast/options.h"
#include "collision_forge/attack/forecast/speed_forecaster.h"
#include "collision_forge/attack/forecast/speed_situations.h"

namespace forge {

/// Forecasts by recorded speed profiles: each row is a situation, the rows after it are what the
/// driver did then. A linear regression over the most similar situations, weighted by similarity,
/// gives the speeds to expect here, and each profile adds how it differed from the speeds to expect
/// there.
class SpeedProfiles : public SpeedForecaster {
 public:
  SpeedProfiles(SpeedSituations recorded, const SpeedProfileOptions& options);

  const std::vector<SpeedProfileRow>& rows() const { return recorded_->rows(); }

  /// Only profiles that last are used: `intervals`, or as many as enough profiles last when these
  /// are fewer. No columns when there are too few profiles for any interval.
  SpeedForecast forecast(const DrivingSituation& situation, int intervals) const override;
  std::shared_ptr<const SpeedForecaster> withoutScene(const std::string& scene) const override;

 private:
  using Neighbors = std::vector<std::pair<double, Eigen::Index>>;  // squared distance, row
  struct Extent {
    int intervals = 0;
    std::size_t neighbors = 0;
  };

  Extent extentOf(int intervals) const;
  Neighbors nearest(const Eigen::ArrayXd& features, const Extent& extent) const;

  std::shared_ptr<const SpeedSituations> recorded_;
  SpeedProfileOptions options_;
  int left_out_ = -1;  ///< number of the scene that has no say
};

}  // namespace forge
