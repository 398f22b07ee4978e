#pragma once

#include <optional>
#include <vector>

#include "collision_forge/planner_test/planners/kinematic_bicycle.h"
#include "collision_forge/planner_test/planners/pdm_options.h"

namespace forge {

// PDM-Closed's emergency brake, as published: poses on a straight line at a constant speed, which
// the tracker converts to braking.

/// Returns whether the ego must brake: the chosen proposal has an at-fault collision within
/// `options.max_time` (`collision`, s from t0) and the ego's `speed` (m/s) is at most
/// `options.max_speed`.
bool firesBrake(double speed, const std::optional<double>& collision,
                const PdmBrakeOptions& options);

/// Returns the constant speed (m/s) of the braking poses; negative is backwards, the usual case for
/// an ego slower than 4 m/s. `speed`: the ego's, m/s; `center_acceleration`: m/s2, of the box's
/// middle.
double brakeSpeed(double speed, double center_acceleration, const PdmBrakeOptions& options);

/// Returns the acceleration (m/s2) of the box's middle along the heading: the rear axle's plus the
/// part caused by turning. `curvature`: 1/m; `center_offset`: m.
double centerAcceleration(const BicycleState& state, double curvature, double center_offset);

/// Returns `steps` + 1 poses `step` seconds apart on a straight line from `start` at `speed` m/s.
std::vector<Pose2> brakePoses(const Pose2& start, double speed, int steps, double step);

}  // namespace forge
