#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <string>

namespace forge {

/// s between the speeds of a profile and between past speeds.
inline constexpr double kProfileStep = 0.5;

/// m; smaller gaps to the vehicle ahead count as this in RoadAhead::closing.
inline constexpr double kMinClosingGap = 2.0;

/// Returns the gap (m) that a driver at `speed` (m/s) desires to the vehicle ahead: 2 m plus the
/// distance driven in 1.2 s.
inline double wishedGap(double speed) { return 2.0 + 1.2 * speed; }

/// Demands of the path ahead on the driver, in quantities to which drivers react about linearly.
struct RoadAhead {
  double turn_rate = 0.0;  ///< rad/s, |turn rate| of the ego over the last kProfileStep
  /// m/s2, deceleration needed to take all bends within 80 m at kComfortableLateralAcceleration,
  /// clamped to -3..6; negative: the driver may accelerate
  double bend_braking = 0.0;
  double bend_turn = 0.0;  ///< rad, |heading at 60 m along the path minus heading at its start|
  double bend_curvature = 0.0;  ///< 1/m, largest |curvature| 10 to 20 m along the path, at most 0.1
  /// wishedGap() at the ego's speed over the gap (m, at least 1.5, along the path) between the
  /// boxes of ego and vehicle ahead, 0 to 2; 0 without a vehicle ahead
  double headway = 0.0;
  /// 1/s, closing speed (positive: the gap shrinks) over that gap, at least kMinClosingGap; clamped
  /// to -1..1; 0 without a vehicle ahead
  double closing = 0.0;
};

/// Situation of a driver: `past_speeds` are mean speeds (m/s, negative when reversing) over the
/// last five intervals of kProfileStep, newest first.
struct DrivingSituation {
  std::array<double, 5> past_speeds = {};
  RoadAhead ahead;
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

  /// Returns speed profiles over the next `intervals` intervals of kProfileStep from t0, or fewer
  /// columns if the model covers fewer; no columns if it has no forecast. Called on the caller's
  /// thread for each candidate path of the ego at each sample(), so it must be fast. Must be
  /// deterministic. May throw std::runtime_error for damaged weights.
  virtual SpeedForecast forecast(const DrivingSituation& situation, int intervals) const = 0;

  /// Returns the model fitted without the recording of `scene`, for tests on that scene; null if
  /// there is none. Called once per test scene, from any thread; must not copy weights or throw.
  virtual std::shared_ptr<const SpeedForecaster> withoutScene(const std::string& scene) const = 0;
};

}  // namespace forge
