#pragma once

#include <Eigen/Core>
#include <string>
#include <unordered_map>
#include <vector>

#include "collision_forge/attack/forecast/options.h"
#include "collision_forge/attack/forecast/speed_forecaster.h"

namespace forge {

/// One recorded frame of the ego; see collectSpeedProfiles().
struct SpeedProfileRow {
  std::string scene;   ///< name of the recording
  int frame = 0;       ///< in steps of kProfileStep; rows with consecutive numbers form a profile
  double speed = 0.0;  ///< m/s, mean since the previous frame, negative when reversing
  RoadAhead ahead;
};

/// Returns the kSpeedFeatures features of a situation, each of order one, in the order described at
/// kSpeedFeatures.
Eigen::ArrayXd featuresOf(const DrivingSituation& situation);

/// Recorded frames, each with the driver's situation and the speeds that followed. A row is one
/// frame, numbered from 0 in the order of the constructor; a row must be in range, which is not
/// checked.
class SpeedSituations {
 public:
  /// Rows of a scene must be contiguous with increasing frames. Throws std::invalid_argument
  /// otherwise and for numbers that are not finite.
  explicit SpeedSituations(std::vector<SpeedProfileRow> rows);

  /// Returns the number of rows.
  Eigen::Index size() const { return features_.rows(); }
  const std::vector<SpeedProfileRow>& rows() const { return rows_; }

  /// Scene names in order of appearance; a scene's number is its index.
  const std::vector<std::string>& scenes() const { return scenes_; }
  /// Returns the scene's index into scenes(), -1 if unknown.
  int sceneNumber(const std::string& name) const;

  /// Returns the index into scenes() of the scene of a row.
  int sceneOf(Eigen::Index row) const { return scene_of_[static_cast<std::size_t>(row)]; }
  /// Returns the number of intervals of kProfileStep recorded without a gap after the row.
  int intervalsAfter(Eigen::Index row) const { return lasts_[static_cast<std::size_t>(row)]; }
  /// Returns SpeedProfileRow::speed, m/s.
  double speed(Eigen::Index row) const { return rows_[static_cast<std::size_t>(row)].speed; }
  /// Returns the driver's situation at the row. Past speeds are the speeds of the rows before;
  /// before a gap or the scene's first row, the oldest of them is repeated.
  const DrivingSituation& situation(Eigen::Index row) const {
    return situations_[static_cast<std::size_t>(row)];
  }
  /// Returns featuresOf() of every row: one matrix row per row, one column per feature.
  const Eigen::ArrayXXd& features() const { return features_; }
  /// Returns the speed in the interval `interval` after the row (0: the next) minus the row's
  /// speed, m/s. `interval` must be less than intervalsAfter(row), which is not checked.
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
