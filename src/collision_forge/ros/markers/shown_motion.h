#pragma once

#include <collision_forge/AgentTrack.h>
#include <collision_forge/AttackerTrajectory.h>
#include <ros/time.h>

#include <optional>

#include "collision_forge/base/geometry/pose2.h"
#include "collision_forge/base/scene/track.h"

/// Poses of boxes between frames: metres, radians, map frame.
namespace forge {

inline constexpr double kLongestGuess = 0.6;  // s; maximum extrapolation after a frame

/// Extrapolates a state by `duration` seconds at constant speed and `turn_rate` (rad/s, positive to
/// the left).
Pose2 movedOn(const AgentState& state, double turn_rate, double duration);

/// Returns the latest turn rate, rad/s; 0 if unknown or the agent hardly moves.
double lastTurnRate(const collision_forge::AgentTrack& track);

/// Extrapolates the newest state to `now`, by kLongestGuess at most and never backwards. `track`
/// must have a state.
Pose2 shownPose(const collision_forge::AgentTrack& track, const ros::Time& now);

/// Returns the state at `now`, s: interpolated, or extrapolated from the newest state with its
/// velocity and turn rate by kLongestGuess at most. Returns nullopt before the first state, in
/// gaps, and if the newest state is too old. States must be in the order of time.
std::optional<AgentState> shownState(const Track& track, double now);

/// Returns the attacker's pose at `now`; its last pose after the end, nullopt before the begin.
std::optional<Pose2> drivenPose(const collision_forge::AttackerTrajectory& trajectory,
                                const ros::Time& now);

}  // namespace forge
