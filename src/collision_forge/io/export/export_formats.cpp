#include "collision_forge/io/export/export_formats.h"

#include <stdexcept>

#include "collision_forge/io/export/common_road.h"
#include "collision_forge/io/export/open_label.h"
#include "collision_forge/io/export/open_scenario.h"
#include "collision_forge/io/export/scenario_net.h"

namespace forge {
namespace {

struct Format {
  const char* name;
  std::unique_ptr<CrashWriter> (*make)(const ExportPlan& plan);
};

constexpr Format kFormats[] = {
    {"openscenario", makeOpenScenarioWriter},
    {"commonroad", makeCommonRoadWriter},
    {"scenarionet", makeScenarioNetWriter},
    {"openlabel", makeOpenLabelWriter},
};

}  // namespace

std::vector<std::string> exportFormats() {
  std::vector<std::string> names;
  for (const Format& format : kFormats) names.emplace_back(format.name);
  return names;
}

std::unique_ptr<CrashWriter> makeCrashWriter(const std::string& format, const ExportPlan& plan) {
  for (const Format& known : kFormats) {
    if (format == known.name) return known.make(plan);
  }
  throw std::invalid_argument("unknown format \"" + format + "\"");
}

}  // namespace forge
