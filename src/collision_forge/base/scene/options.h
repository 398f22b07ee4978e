#pragma once

#include "collision_forge/base/scene/crash_definition.h"
#include "collision_forge/base/scene/input_limits.h"
#include "collision_forge/base/scene/live_options.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

class Section;

// Read the mapping of each struct from its configuration file. Throw ConfigError for a missing key
// or a value out of range.

void readOptions(Section& section, EgoVehicle& vehicle);
void readOptions(Section& section, LiveOptions& live);
void readOptions(Section& section, InputLimits& limits);
/// `time_margin` (s) is the smallest time_tolerance allowed: attacks are planned so far inside it.
void readOptions(Section& section, CrashDefinition& crash, double time_margin);

}  // namespace forge
