#pragma once

#include "attack/attack.h"
#include "attack/motion_estimate.h"
#include "attack/options.h"

namespace forge {

/// Joins the attacker's motion now to the pattern at its time by a quintic polynomial on each axis,
/// start acceleration included and end acceleration zero, then goes straight on for the tail.
AttackerTrajectory joinByQuintic(const Track& attacker, const Motion& motion, double now,
                                 const CollisionPattern& pattern,
                                 const RealizationOptions& options);

}  // namespace forge
