#include "collision_forge/planner_test/settings/config_fingerprint.h"

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

#include "collision_forge/base/files/fingerprint.h"

namespace forge {
namespace {

/// True for files of config/ that no result depends on. Mappings of topics are named on the command
/// line.
bool isIndifferent(const std::string& name) {
  static const std::set<std::string> names = {
      "attacked_bag.yaml", "drawing.yaml", "encoding.yaml",          "export.yaml",
      "generators.yaml",   "live.yaml",    "network_published.yaml", "planner_training.yaml",
      "ranks.yaml",        "report.yaml",  "requests.yaml",          "speed_model_fit.yaml",
      "training.yaml",     "tuning.yaml"};
  return names.count(name) > 0 || name.rfind("topics_", 0) == 0;
}

}  // namespace

std::string fingerprintOfFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  content << file.rdbuf();
  if (!file) throw std::runtime_error(path + ": cannot be read");
  return "fingerprint " + fingerprint(content.str());
}

std::map<std::string, std::string> configFingerprints(const std::string& directory) {
  std::map<std::string, std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(directory)) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() != ".yaml" || isIndifferent(name)) continue;
    found["config/" + name] = fingerprintOfFile(entry.path().string());
  }
  return found;
}

std::map<std::string, std::string> fingerprintsOf(const Config& config,
                                                  const std::string& directory) {
  std::map<std::string, std::string> found = configFingerprints(directory);
  std::map<std::string, std::string> models = {{"speed_model", config.speed_model},
                                               {"pattern_network", config.pattern_network}};
  for (const auto& [name, paths] : config.generator_weights) {
    for (std::size_t i = 0; i < paths.size(); ++i) {
      models[name + (i == 0 ? "" : " fold " + std::to_string(i))] = paths[i];
    }
  }
  for (const auto& [name, path] : models) {
    if (!path.empty()) found[name] = fingerprintOfFile(path);
  }
  return found;
}

std::string fingerprintOfAll(const Config& config, const std::string& directory) {
  std::string found;
  for (const auto& [name, of_file] : fingerprintsOf(config, directory)) {
    found += name + ": " + of_file + "\n";
  }
  return fingerprint(found);
}

}  // namespace forge
