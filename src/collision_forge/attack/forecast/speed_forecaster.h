#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <string>

namespace forge {

/// Seconds between the speeds of a profile, and between the past speeds of a situation.
inline constexpr double kProfileStep = 0.5;

/// m; smaller gaps to a vehicle ahead count as this in WayAhead::closing.
inline constexpr double kMinClosingGap = 2.0;

/// The gap, metres, that a driver at `speed` m/s wishes to the vehicle ahead: 2 m and 1.2 s.
inline double wishedGap(double speed) { return 2.0 + 1.2 * speed; }

/// What the way ahead asks of the driver, in numbers that drivers react to about linearly.
struct WayAhead {
  double turn_rate = 0.0;       ///< rad/s now, without sign
  double bend_braking = 0.0;    ///< m/s2 needed to take the bends within 80 m comfortably, -3 to 6
  double bend_turn = 0.0;       ///< rad, change of heading over the next 60 m, without sign
  double bend_curvature = 0.0;  ///< 1/m, the largest from 10 to 20 m ahead, 0 to 0.1
  double headway = 0.0;         ///< wishedGap() over actual gap to the vehicle ahead, 0 (none) to 2
  double closing = 0.0;         ///< 1/s, closing speed over gap to the vehicle ahead, -1 to 1
};

/// A moment of driving: mean speeds (m/s, negative when reversing) over the newest intervals of
/// kProfileStep, newest first, and the way ahead.
struct DrivingSituation {
  std::array<double, 5> past_speeds = {};
  WayAhead ahead;
};

/// Speeds that a driver may choose from now on.
struct SpeedForecast {
  Eigen::MatrixXd speeds;   ///< m/s, >= 0; a row a profile, a column an interval of kProfileStep
  Eigen::VectorXd weights;  ///< one a profile, sum 1
};

/// Knows how fast drivers go on. Implementations are immutable and may be used from many threads.
class SpeedForecaster {
 public:
  virtual ~SpeedForecaster() = default;

  /// The speeds over the next `intervals`, or over as many as are known; no columns when nothing is
  /// known.
  virtual SpeedForecast forecast(const DrivingSituation& situation, int intervals) const = 0;

  /// The same drivers without what was recorded in that scene, which must not judge itself; null
  /// when this knows no other way. Cheap.
  virtual std::shared_ptr<const SpeedForecaster> withoutScene(const std::string& scene) const = 0;
};

}  // namespace forge
