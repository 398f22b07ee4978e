#pragma once

#include <yaml-cpp/yaml.h>

#include <string>

namespace forge {

/// A value of a configuration file.
struct SectionLayer {
  std::string file;  ///< path of the file that gives the value
  YAML::Node node;   ///< the value: a scalar, list or mapping
};

}  // namespace forge
