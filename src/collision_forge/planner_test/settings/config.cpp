#include "collision_forge/planner_test/settings/config.h"

#include "collision_forge/base/config/section.h"

namespace forge {
namespace {

void readMethods(Section file, Config& config) {
  config.method_libraries = file.paths("libraries");
  file.read("nominal", config.attack.nominal);
  file.finish();
}

}  // namespace

Config loadConfig(const std::string& directory) {
  Config config;
  readAttackOptions(directory, config.attack);
  readConfigFile(directory, "adaptive", config.adaptive);
  readConfigFile(directory, "crash_definition", config.crash, config.attack.search.time_margin);
  readMethods(openConfigFile(directory, "methods.yaml"), config);
  readConfigFile(directory, "models", static_cast<ModelOptions&>(config));
  readConfigFile(directory, "ego_vehicle", config.ego_vehicle);
  readConfigFile(directory, "encoding", config.encoding);
  readConfigFile(directory, "live", config.live);
  readConfigFile(directory, "conversion", config.conversion);
  readConfigFile(directory, "input_limits", config.input_limits);
  readConfigFile(directory, "locations", config.locations);
  readConfigFile(directory, "attacked_bag", config.attacked_bag);
  readConfigFile(directory, "drawing", config.drawing);
  readConfigFile(directory, "requests", config.requests);
  readConfigFile(directory, "report", config.report);
  readConfigFile(openConfigFile(directory, "export.yaml"), config.exports);
  readConfigFile(openConfigFile(directory, "planners.yaml"), config.planners,
                 config.attack.verification.limits);
  return config;
}

}  // namespace forge
