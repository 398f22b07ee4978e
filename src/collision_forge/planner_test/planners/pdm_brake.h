#pragma once

#include <optional>
#include <vector>

#include "collision_forge/planner_test/planners/kinematic_bicycle.h"
#include "collision_forge/planner_test/planners/pdm_options.h"

namespace forge {

// PDM-Closed's emergency brake, as published: poses on a straight line at a constant speed, which
// the tracker converts to braking.

/// Returns whether the ego must brake: the chosen proposal has an at-fault collision within
/// `options.max_time` and the ego's `speed` (m/s) is at most `options.max_speed`. `collision`:
/// PdmScore::collision_time of that proposal, s from t0; nullopt: none.
bool firesBrake(double speed, const std::optional<double>& collision,
                const PdmBrakeOptions& options);

/// Returns the constant speed (m/s) of the braking poses by the formulas at PdmBrakeOptions;
/// negative is backwards, the usual case for an ego slower than 4 m/s. `speed`: the ego's, m/s;
/// `center_acceleration`: m/s2, of the box's middle, as centerAcceleration().
double brakeSpeed(double speed, double center_acceleration, const PdmBrakeOptions& options);

/// Returns the acceleration (m/s2) of the box's middle along the heading: the rear axle's plus the
/// centripetal part, yaw rate^2 * `center_offset`. `curvature`: of the rear axle's path, 1/m;
/// `center_offset`: m from the rear axle to the middle of the box.
double centerAcceleration(const BicycleState& state, double curvature, double center_offset);

/// Returns `steps` + 1 poses of the rear axle, `step` seconds apart, on a straight line from
/// `start` (the first) along its heading at `speed` m/s; backwards if `speed` is negative.
std::vector<Pose2> brakePoses(const Pose2& start, double speed, int steps, double step);

}  // namespace forge
