#include "collision_forge/planner_test/settings/config_fingerprint.h"

#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

#include "collision_forge/base/files/fingerprint.h"

namespace forge {
namespace {

/// Returns whether results do not depend on a file of config/. Topic mappings are set on the
/// command line.
bool isIndifferent(const std::string& name) {
  static const std::set<std::string> names = {
      "attacked_bag.yaml", "drawing.yaml", "encoding.yaml", "export.yaml",   "lidar.yaml",
      "live.yaml",         "phrases.yaml", "report.yaml",   "requests.yaml", "tuning.yaml"};
  return names.count(name) > 0 || name.rfind("topics_", 0) == 0;
}

std::string inWords(const std::string& text) { return "fingerprint " + fingerprint(text); }

}  // namespace

std::string fingerprintOfFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  content << file.rdbuf();
  if (!file) throw std::runtime_error(path + ": cannot be read");
  return inWords(content.str());
}

std::string fingerprintOfValues(const ConfigFolder& folder, const std::string& file) {
  return inWords(folder.values(file));
}

void addWeights(const std::string& model, const std::vector<std::string>& paths,
                std::map<std::string, std::string>& found) {
  for (std::size_t i = 0; i < paths.size(); ++i) {
    found[model + (i == 0 ? "" : " fold " + std::to_string(i))] = fingerprintOfFile(paths[i]);
  }
}

std::map<std::string, std::string> configFingerprints(const ConfigFolder& folder) {
  std::map<std::string, std::string> found;
  for (const std::string& name : folder.files()) {
    if (!isIndifferent(name)) found["config/" + name] = fingerprintOfValues(folder, name);
  }
  return found;
}

std::map<std::string, std::string> fingerprintsOf(const Config& config,
                                                  const ConfigFolder& folder) {
  std::map<std::string, std::string> found = configFingerprints(folder);
  for (const auto& [name, path] : {std::pair("speed_model", config.speed_model),
                                   std::pair("pattern_network", config.pattern_network)}) {
    if (!path.empty()) found[name] = fingerprintOfFile(path);
  }
  return found;
}

std::string fingerprintOfAll(const Config& config, const ConfigFolder& folder) {
  std::string found;
  for (const auto& [name, of_file] : fingerprintsOf(config, folder)) {
    found += name + ": " + of_file + "\n";
  }
  return fingerprint(found);
}

}  // namespace forge
