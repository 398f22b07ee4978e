#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "attack/options.h"

namespace forge {

/// Seconds between the speeds of a profile, and between the past speeds of a situation.
inline constexpr double kProfileStep = 0.5;

/// What the way ahead asks of the driver, in numbers that drivers react to about linearly.
struct WayAhead {
  double turn_rate = 0.0;       ///< rad/s now, without sign
  double bend_braking = 0.0;    ///< m/s2 needed to take the bends within 80 m comfortably, -3 to 6
  double bend_turn = 0.0;       ///< rad, change of heading over the next 60 m, without sign
  double bend_curvature = 0.0;  ///< 1/m, the largest from 10 to 20 m ahead, 0 to 0.1
  double headway = 0.0;         ///< wished over actual gap to the vehicle ahead, 0 (none) to 2
  double closing = 0.0;         ///< 1/s, closing speed over gap to the vehicle ahead, -1 to 1
};

/// A moment of driving: mean speeds (m/s, negative when reversing) over the newest intervals of
/// kProfileStep, newest first, and the way ahead.
struct DrivingSituation {
  std::array<double, 5> past_speeds = {};
  WayAhead ahead;
};

/// One recorded frame.
struct SpeedProfileRow {
  std::string scene;
  int frame = 0;       ///< counts kProfileStep; frames that follow each other form a profile
  double speed = 0.0;  ///< m/s, mean since the frame before
  WayAhead ahead;
};

/// Speeds that a driver may choose from now on.
struct SpeedForecast {
  Eigen::MatrixXd speeds;   ///< m/s, >= 0; a row a profile, a column an interval of kProfileStep
  Eigen::VectorXd weights;  ///< one a profile, sum 1
};

/// Recorded speed profiles: each row is a situation, the rows after it are what the driver did
/// then. Immutable; may be used from many threads.
class SpeedProfiles {
 public:
  /// Rows of one scene together, frames increasing. Throws std::invalid_argument otherwise and for
  /// a number that is not finite.
  explicit SpeedProfiles(std::vector<SpeedProfileRow> rows);

  const std::vector<SpeedProfileRow>& rows() const { return rows_; }

  /// What followed the most similar situations of all scenes but `left_out_scene`: a linear
  /// regression, weighted by similarity, gives the speeds to expect here, and each profile adds how
  /// it differed from the speeds to expect there. Only profiles that last are used: `intervals`, or
  /// as many as enough profiles last when these are fewer. No columns when there are too few
  /// profiles for any interval.
  SpeedForecast forecast(const DrivingSituation& situation, int intervals,
                         const SpeedProfileOptions& options,
                         const std::string& left_out_scene) const;

 private:
  using Neighbors = std::vector<std::pair<double, Eigen::Index>>;  // squared distance, row
  struct Extent {
    int intervals = 0;
    std::size_t neighbors = 0;
  };

  Extent extentOf(int intervals, std::size_t neighbors, int left_out) const;
  Neighbors nearest(const Eigen::ArrayXd& features, int intervals, std::size_t wanted, int left_out,
                    const FeatureWeights& weights) const;
  int sceneNumber(const std::string& name) const;

  std::vector<SpeedProfileRow> rows_;
  std::unordered_map<std::string, int> scene_numbers_;
  std::vector<int> scene_of_;  // one a row
  std::vector<int> lasts_;     // intervals recorded after each row
  Eigen::ArrayXXd features_;   // a row a row, a column a feature
};

}  // namespace forge
