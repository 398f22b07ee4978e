#pragma once

#include "collision_forge/base/scene/crash_definition.h"
#include "collision_forge/base/scene/input_limits.h"
#include "collision_forge/base/scene/live_options.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

class Section;

// Read the mapping of each struct from its configuration file. Throw ConfigError for a missing key
// or a value out of range.

/// config/ego_vehicle.yaml.
void readOptions(Section& section, EgoVehicle& vehicle);
/// config/live.yaml.
void readOptions(Section& section, LiveOptions& live);
/// config/input_limits.yaml; fixed limits keep their defaults.
void readOptions(Section& section, InputLimits& limits);
/// config/crash_definition.yaml. `time_margin` (s, SearchOptions::time_margin) is the smallest
/// time_tolerance allowed: the search keeps attacks by so much inside it.
void readOptions(Section& section, CrashDefinition& crash, double time_margin);

}  // namespace forge
