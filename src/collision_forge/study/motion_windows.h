#pragma once

#include <array>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "collision_forge/scene/attack.h"
#include "collision_forge/scene/track.h"
#include "collision_forge/study/options.h"

namespace forge {

// Three seconds of one vehicle, sampled at 2 Hz as nuScenes is annotated. Recorded and generated
// motion is compared after the same fit alone: second differences of annotated positions are mostly
// noise of the annotation.

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

/// How a vehicle steers, taken for a kinematic single track.
struct Steering {
  double angle = 0.0;  ///< rad, of the front wheels, positive to the left
  double rate = 0.0;   ///< rad/s
};

/// How a vehicle moves at one instant.
struct MotionState {
  double speed = 0.0;                 ///< m/s, never negative
  double acceleration = 0.0;          ///< m/s2 along the motion, braking is negative
  double jerk = 0.0;                  ///< m/s3, third derivative of the position along the motion
  double yaw_rate = 0.0;              ///< rad/s, counter-clockwise
  double yaw_acceleration = 0.0;      ///< rad/s2
  double lateral_acceleration = 0.0;  ///< m/s2, speed times yaw rate, positive to the left
  std::optional<Steering> steering;   ///< at MotionOptions::min_steering_speed or faster
};

/// The motion at the samples of a window, in their order.
using WindowMotion = std::array<MotionState, kWindowSamples>;

/// The samples at which derivatives are of use: the middle one and its neighbours. With position
/// noise of s m the standard deviation of the second derivative of a cubic over seven samples is
/// .9 s m/s2 at the middle, 1.8 s beside it, 3.4 s and 5 s at the last two (least squares).
inline constexpr std::size_t kFirstInner = 2;
inline constexpr std::size_t kLastInner = 4;

/// From cubics in time through x, y and yaw (unwrapped), each by least squares over the samples:
/// speed, acceleration and jerk from those of x and y, yaw rate and yaw acceleration from that of
/// yaw. Steering by the kinematic single track x' = v cos(yaw), yaw' = v tan(angle) / wheelbase
/// (CommonRoad vehicle models 2020a, section 3), so angle = atan(wheelbase * yaw rate / speed).
WindowMotion motionOf(const MotionWindow& window, const MotionOptions& options);

/// Every seven successive states of a recorded vehicle that canAttack(), each 0.25 to 0.75 s after
/// the one before, between which the vehicle moves at MotionOptions::min_speed or faster at every
/// sample (by the fit). Neighbours share six states.
std::vector<MotionWindow> recordedWindows(const std::string& scene, const Track& track,
                                          const MotionOptions& options);

/// What an attacker does before the crash. Samples are at now + k * kWindowStep, those up to now as
/// recorded (stateAt() of `recorded`), those after it of the trajectory; `now` is the time of its
/// first point. The newest sample is the last one `before_contact` or more before `contact_time`:
/// with a whole number of half seconds from now to contact the window lasts from 4.5 to 1.5 s
/// before it. Empty where the recorded past is too short, where no sample is after now, where the
/// vehicle is slower than MotionOptions::min_speed at a sample, and without points.
std::optional<MotionWindow> attackWindow(const std::string& scene, const Track& recorded,
                                         const AttackerTrajectory& trajectory, double contact_time,
                                         const MotionOptions& options);

/// What the fit leaves of the positions of each sample, m along (x) and across (y) the yaw at the
/// middle.
std::array<Vector2, kWindowSamples> fitResiduals(const MotionWindow& window);

/// The windows as an annotator would have recorded them: to the positions of each one's generated
/// samples are added the fit's residuals of a recorded window drawn at random, in random order (in
/// their own order the fit would take them away again) and by sqrt(7 / 3) larger, for of seven
/// samples' noise a cubic takes four sevenths with it. Yaws stay: those of annotators are smooth.
/// Without recorded windows nothing is added.
std::vector<MotionWindow> withRecordedNoise(std::vector<MotionWindow> windows,
                                            const std::vector<MotionWindow>& recorded,
                                            std::mt19937_64& generator);

}  // namespace forge
