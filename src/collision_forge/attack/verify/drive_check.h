#pragma once

#include <optional>
#include <vector>

#include "collision_forge/attack/verify/drive_limits.h"
#include "collision_forge/attack/verify/limits.h"
#include "collision_forge/base/scene/attack.h"

namespace forge {

/// The state that a point tells of itself.
DriveState driveStateOf(const TrajectoryPoint& point, const DriveLimits& limits);

/// Holds what the poses alone say of the points up to the first at or after `until` against the
/// limits of a vehicle that drives as a single track: for each step the way of the rear axle along
/// and across the heading halfway, and the turn; from these speed, steering angle, lateral
/// acceleration, and from step to step acceleration, steering rate and jerk. The motion continues
/// `start`, by the same rates. What is written (speed, acceleration, curvature of the rear axle's
/// path) is held against the poses. Returns the worst broken limit, by ratio: a key of
/// config/vehicle_limits.yaml, or "finite", "no_reversing", "no_slip", "total_acceleration",
/// "continues_pose", "continues_speed", "written_speed", "written_acceleration",
/// "written_curvature".
std::optional<BrokenLimit> findBrokenDrive(const std::vector<TrajectoryPoint>& points,
                                           const DriveState& start, double until,
                                           const DriveLimits& limits);

}  // namespace forge
