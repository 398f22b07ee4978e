#pragma once

#include <optional>
#include <vector>

#include "collision_forge/attack/verify/drive_limits.h"
#include "collision_forge/attack/verify/limits.h"
#include "collision_forge/base/scene/attack.h"

namespace forge {

/// Returns the single-track state that a trajectory point describes: rear axle pose, speed,
/// acceleration, steering angle from the curvature.
DriveState driveStateOf(const TrajectoryPoint& point, const DriveLimits& limits);

/// Checks the poses of the points, up to and including the first at or after `until` (s), against
/// the limits of a kinematic single-track vehicle that continues from `start`. Each step's
/// rear-axle displacement along and across the mean heading, and its turn, give speed, steering
/// angle and lateral acceleration; differences between steps give acceleration, steering rate and
/// jerk. The stored speed, acceleration and curvature must agree with the poses. Returns the
/// violation with the greatest ratio of value to limit, empty if there is none. Its name is a key
/// of config/vehicle_limits.yaml or "finite", "no_reversing", "no_slip", "total_acceleration",
/// "continues_pose", "continues_speed", "written_speed", "written_acceleration",
/// "written_curvature".
std::optional<BrokenLimit> findBrokenDrive(const std::vector<TrajectoryPoint>& points,
                                           const DriveState& start, double until,
                                           const DriveLimits& limits);

}  // namespace forge
