#pragma once

#include <yaml-cpp/yaml.h>

#include <string>

namespace forge {

/// A value of a configuration file, and the path of the file that gives it.
struct SectionLayer {
  std::string file;
  YAML::Node node;
};

}  // namespace forge
