#pragma once

#include <optional>
#include <vector>

#include "collision_forge/attack/verify/drive_limits.h"
#include "collision_forge/attack/verify/limits.h"
#include "collision_forge/base/scene/attack.h"

namespace forge {

/// Returns the single-track state that a trajectory point (box centre) describes: rear axle pose,
/// speed, acceleration, steering angle from the curvature.
DriveState driveStateOf(const TrajectoryPoint& point, const DriveLimits& limits);

/// Checks the poses of the points, up to and including the first at or after `until` (s, clock of
/// the points), against the limits of a kinematic single-track vehicle that continues from `start`,
/// its recorded state at the time of the first point. Each step's rear-axle displacement along and
/// across the mean heading, and its turn, give speed, steering angle and lateral acceleration;
/// differences between steps give acceleration, steering rate and jerk. Small tolerances allow for
/// changes within a step. The stored speed, acceleration and curvature must agree with the poses.
/// Times must increase. Returns the violation with the greatest ratio of value to limit, empty if
/// there is none or no point. Its name is a key of config/vehicle_limits.yaml or "finite" (value
/// and limit are 0), "no_reversing" (m moved backwards in a step), "no_slip" (m moved sideways in a
/// step), "total_acceleration", "continues_pose" (m or rad from `start`), "continues_speed" (m/s2),
/// "written_speed", "written_acceleration", "written_curvature".
std::optional<BrokenLimit> findBrokenDrive(const std::vector<TrajectoryPoint>& points,
                                           const DriveState& start, double until,
                                           const DriveLimits& limits);

}  // namespace forge
