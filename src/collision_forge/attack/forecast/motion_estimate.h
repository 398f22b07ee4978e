#pragma once

#include "collision_forge/base/scene/track.h"

namespace forge {

inline constexpr int kMotionFrames = 4;          ///< newest frames that a motion is fitted to
inline constexpr int kMinHistoryFrames = 2;      ///< frames of the ego needed to derive its motion
inline constexpr double kStandstillSpeed = 0.5;  ///< m/s; a slower agent stands still

/// Motion of an agent at its newest state.
struct Motion {
  Pose2 pose;                 ///< box centre, global map frame, as recorded
  double speed = 0.0;         ///< m/s along the heading; negative when reversing
  double acceleration = 0.0;  ///< m/s2 along the heading
  double yaw_rate = 0.0;      ///< rad/s, counter-clockwise
};

/// Returns the index into `states` of the oldest of the newest `frames` states after the last gap
/// longer than kMaxGap (1.1 s); of all states after that gap if there are fewer than `frames`.
/// `states` must not be empty.
std::size_t unbrokenStart(const std::vector<AgentState>& states, int frames);

/// Estimates the motion at the newest state by least squares over the `frames` newest states after
/// unbrokenStart(): a parabola in time for positions, a line for yaws. Two states give no
/// acceleration, one gives standstill. Ignores recorded velocities, which may use later states.
/// Throws std::invalid_argument if `track` has no states.
Motion estimateMotion(const Track& track, int frames = kMotionFrames);

}  // namespace forge
