#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/track.h"

namespace forge {

// Windows of 3 s of the motion of one vehicle, sampled at 2 Hz like nuScenes annotations.
// python/collision_forge_study/motion.py derives speeds, accelerations and steering from them.

inline constexpr std::size_t kWindowSamples = 7;
inline constexpr double kWindowStep = 0.5;  // s between samples

/// The pose of a vehicle at one time.
struct WindowSample {
  double time = 0.0;  ///< s, the scene's clock
  Pose2 pose;         ///< of the centre of the box, map frame
};

/// The motion of one vehicle over 3 s.
struct MotionWindow {
  std::string scene;  ///< its name
  std::string id;     ///< of the vehicle
  AgentClass agent_class = AgentClass::kCar;
  BoxSize size;
  std::array<WindowSample, kWindowSamples> samples;  ///< about kWindowStep apart, ascending in time
  std::size_t generated = 0;  ///< number of samples at the end that are generated, not recorded
};

/// Returns all windows of seven successive states of a recorded vehicle, if canAttack() holds for
/// its class, with 0.25 to 0.75 s between successive states. Successive windows overlap by six
/// states. Omits vehicles at standstill: less than 1 m between first and last sample.
std::vector<MotionWindow> recordedWindows(const std::string& scene, const Track& track);

/// Returns the window of an attacker before the contact. Samples are at t0 + k * kWindowStep, where
/// t0 is the time of the trajectory's first point: up to t0 from `recorded`, later from the
/// trajectory. The last sample is the latest one at least `before_contact` s before `contact_time`
/// (s, the scene's clock). Example: with 1.5 s and a multiple of 0.5 s from t0 to the contact, the
/// window covers 4.5 to 1.5 s before the contact. Returns nullopt if `recorded` is too short, no
/// sample is after t0, or the trajectory has no points.
std::optional<MotionWindow> attackWindow(const std::string& scene, const Track& recorded,
                                         const AttackerTrajectory& trajectory, double contact_time,
                                         double before_contact);

}  // namespace forge
