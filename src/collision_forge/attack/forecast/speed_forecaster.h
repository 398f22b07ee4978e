#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <string>

namespace forge {

/// s between the speeds of a profile and between past speeds.
inline constexpr double kProfileStep = 0.5;

/// m; smaller gaps to the vehicle ahead count as this in WayAhead::closing.
inline constexpr double kMinClosingGap = 2.0;

/// Returns the gap (m) that a driver at `speed` (m/s) desires to the vehicle ahead: 2 m plus 1.2 s.
inline double wishedGap(double speed) { return 2.0 + 1.2 * speed; }

/// Demands of the path ahead on the driver, in quantities to which drivers react about linearly.
struct WayAhead {
  double turn_rate = 0.0;       ///< rad/s at t0, absolute
  double bend_braking = 0.0;    ///< m/s2 to take the bends within 80 m comfortably, -3 to 6
  double bend_turn = 0.0;       ///< rad, |heading change| over the next 60 m
  double bend_curvature = 0.0;  ///< 1/m, maximum 10 to 20 m ahead, 0 to 0.1
  double headway = 0.0;         ///< wishedGap() / actual gap to the vehicle ahead, 0 (none) to 2
  double closing = 0.0;         ///< 1/s, closing speed / gap to the vehicle ahead, -1 to 1
};

/// Situation of a driver: `past_speeds` are mean speeds (m/s, negative when reversing) over the
/// last five intervals of kProfileStep, newest first.
struct DrivingSituation {
  std::array<double, 5> past_speeds = {};
  WayAhead ahead;
};

/// Weighted speed profiles from t0 on.
struct SpeedForecast {
  Eigen::MatrixXd speeds;   ///< m/s, >= 0; row: profile, column: interval of kProfileStep
  Eigen::VectorXd weights;  ///< one per profile, sum 1
};

/// Interface: forecasts the speeds that a driver may choose. Implementations must be immutable: one
/// object is used from many threads at once.
class SpeedForecaster {
 public:
  virtual ~SpeedForecaster() = default;

  /// Returns speed profiles over the next `intervals` intervals, or fewer columns if the model
  /// covers fewer; no columns if it has no forecast. Called on the caller's thread for each
  /// candidate path of the ego at each sample(), so it must be fast. Must be deterministic. May
  /// throw std::runtime_error for damaged weights.
  virtual SpeedForecast forecast(const DrivingSituation& situation, int intervals) const = 0;

  /// Returns the model fitted without the recording of `scene`, for tests on that scene; null if
  /// there is none. Called once per test scene, from any thread; must not copy weights or throw.
  virtual std::shared_ptr<const SpeedForecaster> withoutScene(const std::string& scene) const = 0;
};

}  // namespace forge
