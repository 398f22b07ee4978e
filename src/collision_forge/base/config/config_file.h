#pragma once

#include <string>

#include "collision_forge/base/config/config_folder.h"
#include "collision_forge/base/config/section.h"

namespace forge {

/// Opens the file `name` (relative to the folder, as "search.yaml") of the configuration, with its
/// overlay merged. Throws ConfigError if the complete folder lacks the file or a file is not a YAML
/// mapping.
Section openConfigFile(const ConfigFolder& folder, const std::string& name);

/// Opens `text`, the content of a configuration file. `path` need not exist: error messages name
/// it, and relative paths in the text are resolved against its folder. Throws ConfigError if `text`
/// is not a YAML mapping.
Section openConfigText(const std::string& path, const std::string& text);

/// Reads a whole file with readOptions(file, options, more...); `more`: the further arguments of
/// the readOptions() of `options`, if any. Throws ConfigError, also for a key that readOptions()
/// does not read.
template <class Options, class... More>
void readConfigFile(Section file, Options& options, const More&... more) {
  readOptions(file, options, more...);
  file.finish();
}

/// Reads KEY.yaml, whose only top-level mapping is KEY, with readOptions(mapping, options,
/// more...). Throws ConfigError, also for a key that readOptions() does not read.
template <class Options, class... More>
void readConfigFile(const ConfigFolder& folder, const std::string& key, Options& options,
                    const More&... more) {
  Section file = openConfigFile(folder, key + ".yaml");
  file.read(key, options, more...);
  file.finish();
}

}  // namespace forge
