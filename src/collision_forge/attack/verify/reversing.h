#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_forge/attack/verify/options.h"
#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/attack.h"

namespace forge {

// A vehicle that reverses is a single track that drives forward with its rear ahead: the axle that
// does not steer leads. Search and checks of limits treat it so; all other code sees its heading,
// and a negative speed.

/// Returns the pose with its yaw turned by pi.
Pose2 turnedRound(Pose2 pose);

/// Converts the points of a vehicle between heading and direction of travel: turns the yaws by pi
/// and negates speeds, accelerations and curvatures. Its own inverse.
void turnRound(std::vector<TrajectoryPoint>& points);

/// Returns the limits of a vehicle that reverses, in its direction of travel: axle_to_middle is
/// negative, the speed is at most DriveLimitOptions::max_reverse_speed.
DriveLimits reversingLimits(const Track& attacker, const VerificationOptions& options);

/// Returns the state in the direction of travel of a vehicle that stands at the last state of its
/// track and is about to reverse. Throws std::invalid_argument if the track has no states.
DriveState reversingStateNow(const Track& attacker, const VerificationOptions& options);

/// Returns true if a vehicle with this box (map frame) stands in a bay, a drive or a car park: its
/// corners and samplePointsOf() are on the drivable area, on no walkway and farther than 1.75 m
/// from all centrelines, as is the ground up to 8 m before its front as far as it is drivable (else
/// it stands between two lanes). False if the map has no drivable area.
bool isInBay(const OrientedBox& box, const LaneIndex& lanes);

/// Returns the smallest distance (m, up to 18) from `meeting`, whose yaw is the direction of
/// travel, straight back to the place of the box centre at which a vehicle of `size` with its rear
/// towards the meeting isInBay(); empty if there is none, or if it would leave drivable area and
/// walkways on the way from there.
std::optional<double> bayBehind(const Pose2& meeting, const BoxSize& size, const LaneIndex& lanes);

/// Returns the reason why an attack by a vehicle that reverses (box centres and headings, map
/// frame) is implausible, worded to follow "the attacker"; empty if it is plausible: isInBay() at
/// its first point, and up to `contact` (s, clock of the points) at most options.max_off_road of
/// its box is off drivable area and walkways, which drives may cross. `points` must not be empty.
std::string implausibleReversing(const std::vector<TrajectoryPoint>& points, const BoxSize& size,
                                 double contact, const LaneIndex& lanes,
                                 const BelievabilityOptions& options);

}  // namespace forge
