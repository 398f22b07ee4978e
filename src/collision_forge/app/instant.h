#pragma once

#include <string>

#include "collision_forge/base/scene/moment.h"
#include "collision_forge/planner_test/settings/config.h"

namespace forge {

/// Returns the time (s, the scene's clock) of the last frame at or before `now` (to 1 us), which is
/// in s from the scene's first frame. Throws std::invalid_argument, naming --now, for a `now`
/// outside the recording: NaN, more than 1 us before the first frame, or after the last one. The
/// scene must have a frame.
double frameTimeOf(const Scene& scene, double now);

/// Reads the bag at path `bag` (readBag()) and indexes its lanes; prints warnings on stderr. Throws
/// BagError and InputError as readBag().
IndexedScene readRecording(const std::string& bag, const Config& config);

}  // namespace forge
