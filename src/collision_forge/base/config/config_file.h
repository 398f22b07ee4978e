#pragma once

#include <string>

#include "collision_forge/base/config/config_folder.h"
#include "collision_forge/base/config/section.h"

namespace forge {

/// The whole of one file of the configuration.
Section openConfigFile(const ConfigFolder& folder, const std::string& name);

/// The same of a file's text; `path` is what errors name.
Section openConfigText(const std::string& path, const std::string& text);

/// Reads a whole file by its readOptions().
template <class Options, class... More>
void readConfigFile(Section file, Options& options, const More&... more) {
  readOptions(file, options, more...);
  file.finish();
}

/// Reads the only mapping of the file KEY.yaml of the configuration by its readOptions().
template <class Options, class... More>
void readConfigFile(const ConfigFolder& folder, const std::string& key, Options& options,
                    const More&... more) {
  Section file = openConfigFile(folder, key + ".yaml");
  file.read(key, options, more...);
  file.finish();
}

}  // namespace forge
