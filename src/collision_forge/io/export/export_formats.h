#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision_forge/io/export/crash_writer.h"

namespace forge {

/// Returns the names of the export formats: "openscenario", "commonroad", "scenarionet",
/// "openlabel".
std::vector<std::string> exportFormats();

/// Makes the writer of a format. Throws std::invalid_argument for an unknown format, and for a plan
/// that the format does not support. `plan` is copied.
std::unique_ptr<CrashWriter> makeCrashWriter(const std::string& format, const ExportPlan& plan);

}  // namespace forge
