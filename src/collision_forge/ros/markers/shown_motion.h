#pragma once

#include <collision_forge/AgentTrack.h>
#include <collision_forge/AttackerTrajectory.h>
#include <ros/time.h>

#include <optional>

#include "collision_forge/base/geometry/pose2.h"
#include "collision_forge/base/scene/track.h"

/// Where boxes are shown between frames: metres, radians, map frame.
namespace forge {

inline constexpr double kLongestGuess = 0.6;  // s after a frame; what comes later stands still

/// Where what drives on with its velocity and that turn rate (rad/s, positive to the left) is
/// `duration` seconds later.
Pose2 movedOn(const AgentState& state, double turn_rate, double duration);

/// How fast a track turned last, rad/s; 0 where it hardly moves or nobody knows.
double lastTurnRate(const collision_forge::AgentTrack& track);

/// The newest state of a track moved on to `now`, by kLongestGuess at most and never back. The
/// track has a state.
Pose2 shownPose(const collision_forge::AgentTrack& track, const ros::Time& now);

/// Where a track of newer and newer states is at `now`: between its states, or the newest one moved
/// on with its velocity and its last turn rate, by kLongestGuess at most. Empty before the first
/// state, in gaps, and where the newest state is older than that.
std::optional<AgentState> shownState(const Track& track, double now);

/// Where its trajectory has an attacker at `now`; at its end from then on, empty before its begin.
std::optional<Pose2> drivenPose(const collision_forge::AttackerTrajectory& trajectory,
                                const ros::Time& now);

}  // namespace forge
