#pragma once

#include <optional>
#include <vector>

#include "collision_forge/planner_test/planners/kinematic_bicycle.h"
#include "collision_forge/planner_test/planners/pdm_options.h"

namespace forge {

// PDM-Closed's emergency brake, as it is published: poses on a straight line at one speed, that a
// tracker makes braking of.

/// True where the chosen proposal collides by its own fault within options.max_time (`collision`, s
/// from now) and the ego is no faster than options.max_speed.
bool firesBrake(double speed, const std::optional<double>& collision,
                const PdmBrakeOptions& options);

/// The constant speed, m/s, at which the poses are laid out; negative is backwards, as it mostly is
/// for an ego below 4 m/s. `center_acceleration`, m/s2, of the box's middle.
double brakeSpeed(double speed, double center_acceleration, const PdmBrakeOptions& options);

/// Of the box's middle along the heading: that of the rear axle and what turning adds to it.
double centerAcceleration(const BicycleState& state, double curvature, double center_offset);

/// `steps` + 1 poses, every `step` seconds, from `start` on.
std::vector<Pose2> brakePoses(const Pose2& start, double speed, int steps, double step);

}  // namespace forge
