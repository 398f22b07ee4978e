#pragma once

#include <string>

#include "collision_forge/base/scene/moment.h"
#include "collision_forge/planner_test/settings/config.h"

namespace forge {

/// The time of the frame at or before `now` seconds after the scene's first. Throws
/// std::invalid_argument, naming --now, outside the recording.
double frameTimeOf(const Scene& scene, double now);

/// A bag, its oddities said on stderr. Throws BagError.
IndexedScene readRecording(const std::string& bag, const Config& config);

}  // namespace forge
