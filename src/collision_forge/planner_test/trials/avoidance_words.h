#pragma once

#include <string>

#include "collision_forge/planner_test/trials/evasive_drives.h"

namespace forge {

/// Returns how a hit could have been avoided, worded to follow "avoidable ": "by braking until
/// 2.0 s" (the last start that works), "by braking at once" (only from now on).
/// `start`: s from now. `is_escape`: from an Escape, where kKeeping keeps the speed that the ego
/// has at `start`; else from an Avoidance, where kKeeping is the recorded drive.
std::string avoidanceWords(EvasiveManoeuvre manoeuvre, double start, bool is_escape);

}  // namespace forge
