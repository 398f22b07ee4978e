#pragma once

#include "collision_forge/base/scene/track.h"

namespace forge {

inline constexpr int kMotionFrames = 4;          ///< newest frames that a motion is fitted to
inline constexpr int kMinHistoryFrames = 2;      ///< frames of the ego needed to derive its motion
inline constexpr double kStandstillSpeed = 0.5;  ///< m/s; a slower agent stands still

/// How an agent moves at the instant of its newest state.
struct Motion {
  Pose2 pose;                 ///< box centre, global map frame, as recorded
  double speed = 0.0;         ///< m/s along the heading; negative when reversing
  double acceleration = 0.0;  ///< m/s2 along the heading
  double yaw_rate = 0.0;      ///< rad/s
};

/// Index of the first of the newest `frames` states that no gap above 1.1 s parts; there must be
/// one state at least.
std::size_t unbrokenStart(const std::vector<AgentState>& states, int frames);

/// Fits a parabola in time to the positions, and a line to the yaws, of the `frames` newest states
/// from unbrokenStart() on: least squares, evaluated at the newest. Two states give a velocity
/// without acceleration, one gives standstill. The past alone is looked at, recorded velocities
/// (which may look ahead) are not. Throws std::invalid_argument for a track without states.
Motion estimateMotion(const Track& track, int frames = kMotionFrames);

}  // namespace forge
