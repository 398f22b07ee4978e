#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision_forge/io/export/crash_writer.h"

namespace forge {

/// The formats by their names: "openscenario", ...
std::vector<std::string> exportFormats();

/// Throws std::invalid_argument for an unknown name, and for a plan that the format cannot keep.
std::unique_ptr<CrashWriter> makeCrashWriter(const std::string& format, const ExportPlan& plan);

}  // namespace forge
