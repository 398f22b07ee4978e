#pragma once

#include <Eigen/Core>
#include <string>
#include <unordered_map>
#include <vector>

#include "collision_forge/attack/forecast/options.h"
#include "collision_forge/attack/forecast/speed_forecaster.h"

namespace forge {

/// One recorded frame.
struct SpeedProfileRow {
  std::string scene;
  int frame = 0;       ///< counts kProfileStep; frames that follow each other form a profile
  double speed = 0.0;  ///< m/s, mean since the frame before
  WayAhead ahead;
};

/// What situations are compared by, of order one, in the order of FeatureWeights.
Eigen::ArrayXd featuresOf(const DrivingSituation& situation);

/// Recorded frames, each with the situation that the driver was in and what the driver did next.
class SpeedSituations {
 public:
  /// Rows of one scene together, frames increasing. Throws std::invalid_argument otherwise and for
  /// a number that is not finite.
  explicit SpeedSituations(std::vector<SpeedProfileRow> rows);

  Eigen::Index size() const { return features_.rows(); }
  const std::vector<SpeedProfileRow>& rows() const { return rows_; }

  /// In order of appearance; numbered by their place.
  const std::vector<std::string>& scenes() const { return scenes_; }
  /// -1 for a scene that is not among them.
  int sceneNumber(const std::string& name) const;

  int sceneOf(Eigen::Index row) const { return scene_of_[static_cast<std::size_t>(row)]; }
  /// Intervals of kProfileStep recorded after a row.
  int lasts(Eigen::Index row) const { return lasts_[static_cast<std::size_t>(row)]; }
  double speed(Eigen::Index row) const { return rows_[static_cast<std::size_t>(row)].speed; }
  const DrivingSituation& situation(Eigen::Index row) const {
    return situations_[static_cast<std::size_t>(row)];
  }
  /// A row a row, a column a feature.
  const Eigen::ArrayXXd& features() const { return features_; }
  /// m/s of the interval `interval` (0 is the first) after a row that lasts so long, over its own.
  double gain(Eigen::Index row, int interval) const {
    return speed(row + interval + 1) - speed(row);
  }

 private:
  std::vector<SpeedProfileRow> rows_;
  std::vector<std::string> scenes_;
  std::unordered_map<std::string, int> scene_numbers_;
  std::vector<int> scene_of_;
  std::vector<int> lasts_;
  std::vector<DrivingSituation> situations_;
  Eigen::ArrayXXd features_;
};

}  // namespace forge
