#pragma once

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "collision_forge/study/motion_windows.h"
#include "collision_forge/study_settings/study_config.h"

namespace forge {

/// What config/ says.
inline ScorecardOptions shippedScorecardOptions() {
  static const ScorecardOptions options =
      loadStudyConfig(COLLISION_FORGE_SOURCE_DIR "/config").evaluation.scorecard;
  return options;
}

/// Straight along x and then turning: x = speed t + acceleration t^2 / 2, yaw = yaw_rate t, t from
/// the middle.
inline MotionWindow simpleWindow(const std::string& scene, double speed, double acceleration,
                                 double yaw_rate = 0.0) {
  MotionWindow window{scene, "vehicle", AgentClass::kCar, {4.6, 1.9}, {}, kWindowSamples};
  for (std::size_t i = 0; i < kWindowSamples; ++i) {
    const double t = kWindowStep * (static_cast<double>(i) - 3.0);
    window.samples[i] = {100.0 + t, {speed * t + 0.5 * acceleration * t * t, 0.0, yaw_rate * t}};
  }
  return window;
}

/// `each` windows in each of `scenes` scenes, at 6 to 9 m/s, accelerations normal around `mean`.
inline std::vector<MotionWindow> drawnWindows(int scenes, int each, double mean,
                                              std::mt19937_64& generator) {
  std::uniform_real_distribution<double> speed(6.0, 9.0);
  std::normal_distribution<double> acceleration(mean, 0.5), yaw_rate(0.0, 0.1);
  std::vector<MotionWindow> windows;
  for (int i = 0; i < scenes * each; ++i) {
    windows.push_back(simpleWindow("scene-" + std::to_string(i / each), speed(generator),
                                   acceleration(generator), yaw_rate(generator)));
  }
  return windows;
}

}  // namespace forge
