#pragma once

#include <string>

#include "collision_forge/planner_test/trials/evasive_drives.h"

namespace forge {

/// Returns how a hit could have been avoided, worded to follow "avoidable ": "up to 2.0 s after t0
/// by braking" (the latest start that works), "at once by braking" (only from t0 on), "by driving
/// as recorded"; for kKeeping of an Evasion "by keeping its speed from 2.0 s after t0 on", or "by
/// keeping its speed" from t0 on. The manoeuvres are "braking", "accelerating", "steering" and, for
/// kBoth, "braking and steering". Times have one decimal; a `start` below kTimeEpsilon is "at
/// once". `start`: s after t0 of the manoeuvre. `is_evasion`: true if `manoeuvre` comes from an
/// Evasion, where kKeeping keeps the ego's speed at `start`; false if it comes from an Avoidance,
/// where kKeeping is the recorded drive.
std::string avoidanceText(EvasiveManoeuvre manoeuvre, double start, bool is_evasion);

}  // namespace forge
