#pragma once

#include "collision_forge/base/scene/attack.h"
#include "collision_forge/io/json/json_line.h"

namespace forge {

// Fields of scenario files and results that concern severity, as docs/severity.md defines them.
// Times in s from `now`, rounded to 1 us.

/// Writes the object `key`.
void writeSeverity(JsonLineWriter& writer, const char* key, const CrashSeverity& severity);
/// Throws JsonLineError, also for a probability or a class out of range.
CrashSeverity readSeverity(JsonObject object);

/// Writes the array "careful_drivers".
void writeCarefulDrivers(JsonLineWriter& writer, const std::vector<CarefulDrive>& drives,
                         double now);
/// Reads that array. Throws JsonLineError, also for an unknown driver.
std::vector<CarefulDrive> readCarefulDrivers(JsonObject& object, double now);

}  // namespace forge
