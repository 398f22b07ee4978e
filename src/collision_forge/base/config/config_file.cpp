#include "collision_forge/base/config/config_file.h"

#include <yaml-cpp/yaml.h>

#include "collision_forge/base/config/config_error.h"
#include "collision_forge/base/config/section_layer.h"

namespace forge {

Section openConfigFile(const ConfigFolder& folder, const std::string& name) {
  return folder.open(name);
}

Section openConfigText(const std::string& path, const std::string& text) {
  try {
    return {"", {{path, YAML::Load(text)}}};
  } catch (const YAML::Exception& error) {
    throw ConfigError(path + ": " + error.what());
  }
}

}  // namespace forge
