#pragma once

#include <collision_forge/AgentTrack.h>
#include <collision_forge/AttackerTrajectory.h>
#include <ros/time.h>

#include <optional>

#include "collision_forge/base/geometry/pose2.h"
#include "collision_forge/base/scene/track.h"

/// Poses of boxes between frames: metres, radians, map frame.
namespace forge {

inline constexpr double kLongestGuess = 0.6;  // s of extrapolation after a frame

/// Returns the pose after `duration` s with constant speed and `turn_rate` (rad/s, positive to the
/// left).
Pose2 movedOn(const AgentState& state, double turn_rate, double duration);

/// Returns the last turn rate of a track, rad/s; 0 if it hardly moves or the rate is unknown.
double lastTurnRate(const collision_forge::AgentTrack& track);

/// Extrapolates the newest state of a track to `now`, by at most kLongestGuess and never back.
/// `track` must have a state.
Pose2 shownPose(const collision_forge::AgentTrack& track, const ros::Time& now);

/// Returns the state of a track at `now`: interpolated, or extrapolated from the newest state with
/// its velocity and last turn rate, by at most kLongestGuess. Empty before the first
/// state, in gaps, and where the newest state is older than that.
std::optional<AgentState> shownState(const Track& track, double now);

/// Returns the trajectory's pose at `now`: the last pose after its end, empty before its begin.
std::optional<Pose2> drivenPose(const collision_forge::AttackerTrajectory& trajectory,
                                const ros::Time& now);

}  // namespace forge
