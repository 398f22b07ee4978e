#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/base/config/config_file.h"

namespace forge {
namespace {

void readMethods(Section file, Config& config) {
  config.method_libraries = file.paths("libraries");
  file.finish();
}

/// Returns the paths of weights in the configuration.
std::vector<std::string*> weightsOf(Config& config) {
  return {&config.pattern_network, &config.speed_model, &config.planners.torchscript.file};
}

}  // namespace

Config loadConfig(const ConfigFolder& folder) {
  folder.check();
  Config config;
  readAttackOptions(folder, config.attack);
  readConfigFile(folder, "adaptive", config.adaptive);
  readConfigFile(folder, "crash_definition", config.crash, config.attack.search.time_margin);
  readMethods(openConfigFile(folder, "methods.yaml"), config);
  config.folder = folder;
  readConfigFile(folder, "models", static_cast<ModelOptions&>(config));
  readConfigFile(folder, "ego_vehicle", config.ego_vehicle);
  readConfigFile(folder, "encoding", config.encoding);
  readConfigFile(folder, "lidar", config.lidar);
  readConfigFile(folder, "live", config.live);
  readConfigFile(folder, "conversion", config.conversion);
  readConfigFile(folder, "input_limits", config.input_limits);
  readConfigFile(folder, "locations", config.locations);
  readConfigFile(folder, "categories", config.categories);
  readConfigFile(folder, "attacked_bag", config.attacked_bag);
  readConfigFile(folder, "drawing", config.drawing);
  readConfigFile(folder, "requests", config.requests);
  readConfigFile(folder, "report", config.report);
  readConfigFile(openConfigFile(folder, "export.yaml"), config.exports);
  config.origins = config.exports.origins;
  readConfigFile(openConfigFile(folder, "planners.yaml"), config.planners,
                 config.attack.verification.limits);
  for (std::string* path : weightsOf(config)) *path = allowedWeights(config, *path);
  return config;
}

std::string describeWeights(const Config& config) {
  const std::string weights = "weights with a non-commercial licence (CC BY-NC-SA 4.0): ";
  if (!config.non_commercial_weights) {
    return weights + "switched off by " + kNonCommercialKey + ": false";
  }
  Config named = config;
  std::string names;
  for (const std::string* path : weightsOf(named)) {
    if (!isNonCommercial(*path)) continue;
    names += (names.empty() ? "" : ", ") + path->substr(path->rfind('/') + 1);
  }
  if (names.empty()) return weights + "not in use";
  return weights + "in use (" + names + "); " + kNonCommercialKey + ": false switches them off";
}

}  // namespace forge
