#pragma once

#include "collision_forge/base/scene/crash_definition.h"
#include "collision_forge/base/scene/input_limits.h"
#include "collision_forge/base/scene/live_options.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

class Section;

void readOptions(Section& section, EgoVehicle& vehicle);
void readOptions(Section& section, LiveOptions& live);
void readOptions(Section& section, InputLimits& limits);
/// Attacks keep `time_margin` to the ends of the time tolerance.
void readOptions(Section& section, CrashDefinition& crash, double time_margin);

}  // namespace forge
