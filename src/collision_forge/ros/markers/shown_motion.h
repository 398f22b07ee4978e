#pragma once

#include <collision_forge/AgentTrack.h>
#include <collision_forge/AttackerTrajectory.h>
#include <ros/time.h>

#include <optional>

#include "collision_forge/base/geometry/pose2.h"
#include "collision_forge/base/scene/track.h"

/// Poses of boxes (middle of the box) between and after frames: metres, radians, map frame; times
/// on the scene's clock.
namespace forge {

inline constexpr double kLongestGuess = 0.6;  // s; maximum extrapolation after a frame

/// Returns the pose of a state after `duration` seconds at constant speed and `turn_rate` (rad/s,
/// positive to the left): its velocity and its yaw turn together.
Pose2 movedOn(const AgentState& state, double turn_rate, double duration);

/// Returns the turn rate, rad/s, positive to the left, between the last two states (by the shorter
/// turn), limited to +-1 rad/s; 0 with fewer than two states, if they are more than kMaxGap apart
/// or not in order, and if the last state is slower than 0.5 m/s.
double lastTurnRate(const collision_forge::AgentTrack& track);

/// Returns the pose of the newest state, moved on to `now` with lastTurnRate(), by kLongestGuess at
/// most (it stays there for a later `now`) and never backwards. `track` must have a state.
Pose2 shownPose(const collision_forge::AgentTrack& track, const ros::Time& now);

/// Returns the state at `now`, s: interpolated (stateAt()), or extrapolated from the newest state
/// with its velocity and turn rate (by the rule of lastTurnRate(), from the states of `track`),
/// with the newest velocity unchanged. Returns nullopt without states, before the first state, in
/// gaps above kMaxGap, and more than kLongestGuess after the newest state. States must be in the
/// order of time.
std::optional<AgentState> shownState(const Track& track, double now);

/// Returns the attacker's pose at `now`, interpolated between the points before and after; its last
/// pose after the end, nullopt before the first point (t0) and without points.
std::optional<Pose2> drivenPose(const collision_forge::AttackerTrajectory& trajectory,
                                const ros::Time& now);

}  // namespace forge
