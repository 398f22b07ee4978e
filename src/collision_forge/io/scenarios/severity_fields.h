#pragma once

#include "collision_forge/base/scene/attack.h"
#include "collision_forge/io/json/json_line.h"

namespace forge {

// Fields of scenario files and results that concern severity, as docs/severity.md defines them.
// Times in s from `now`, rounded to 1 us.

/// Writes the object `key`, as a field of the open object.
void writeSeverity(JsonLineWriter& writer, const char* key, const CrashSeverity& severity);
/// Reads an object of writeSeverity(). Throws JsonLineError, also for a probability or a class out
/// of range.
CrashSeverity readSeverity(JsonObject object);

/// Writes the array "careful_drivers" as a field of the open object. `now`: t0, s on the clock of
/// `drives`.
void writeCarefulDrivers(JsonLineWriter& writer, const std::vector<CarefulDrive>& drives,
                         double now);
/// Reads the array "careful_drivers" of `object`; `now` as above. Throws JsonLineError, also if the
/// field is missing or null, for more drives than kDriverModels has, for an unknown driver, and for
/// a time outside of 0 to 3600 s from `now`.
std::vector<CarefulDrive> readCarefulDrivers(JsonObject& object, double now);

}  // namespace forge
