#pragma once

#include "collision_forge/planners/pdm_motion.h"
#include "collision_forge/planners/pdm_options.h"

namespace forge {

/// The slope of the line that fits the values around each place best, per second: over `window`
/// values, fewer at the ends. Two values or more.
std::vector<double> slopes(const std::vector<double>& values, int window, double step);

/// True when the motion of the rear axle, one state every `step` seconds, keeps all limits. Rates
/// of change are slopes().
bool isComfortable(const PdmMotion& motion, const KinematicBicycle& bicycle, double step,
                   const PdmComfortOptions& options);

}  // namespace forge
