#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/track.h"

namespace forge {

// Three seconds of one vehicle, sampled at 2 Hz as nuScenes is annotated.
// python/collision_forge_study/motion.py derives speeds, accelerations and steering from them.

inline constexpr std::size_t kWindowSamples = 7;
inline constexpr double kWindowStep = 0.5;  // s between samples

/// Where the middle of a vehicle's box was. Global map frame.
struct WindowSample {
  double time = 0.0;  ///< s, the scene's clock
  Pose2 pose;
};

/// What one vehicle did in 3 s.
struct MotionWindow {
  std::string scene;  ///< its name
  std::string id;     ///< of the vehicle
  AgentClass agent_class = AgentClass::kCar;
  BoxSize size;
  std::array<WindowSample, kWindowSamples> samples;  ///< kWindowStep apart, about
  std::size_t generated = 0;                         ///< the newest so many are not recorded
};

/// All windows of seven successive states of a recorded vehicle that canAttack(), whose
/// neighbouring states are 0.25 to 0.75 s apart. Neighbouring windows share six states. Leaves out
/// windows of vehicles that stand: first and last sample less than 1 m apart.
std::vector<MotionWindow> recordedWindows(const std::string& scene, const Track& track);

/// The window of an attacker before the crash. The samples are at now + k * kWindowStep; `now` is
/// the time of the trajectory's first point. Samples up to now are taken from `recorded`
/// (stateAt()), later ones from the trajectory. The newest sample is the last one at least
/// `before_contact` seconds before `contact_time`: with 1.5 s and a whole number of half seconds
/// from now to the contact, the window lasts from 4.5 to 1.5 s before the contact. Returns nullopt
/// if `recorded` is too short, if no sample is after now, and for a trajectory without points.
std::optional<MotionWindow> attackWindow(const std::string& scene, const Track& recorded,
                                         const AttackerTrajectory& trajectory, double contact_time,
                                         double before_contact);

}  // namespace forge
