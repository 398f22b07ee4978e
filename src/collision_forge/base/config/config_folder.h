#pragma once

#include <string>
#include <vector>

#include "collision_forge/base/config/section.h"

namespace forge {

/// Where the files of configuration are read from: a complete folder, over which the files and keys
/// of another folder, the overlay, are laid. Of a file that both have, mappings are merged key by
/// key; every other value of the overlay replaces the one below it. A path is relative to the
/// folder of the file that gives it; a value that is repeated from the complete folder stays that
/// folder's.
///
/// Files are named as "search.yaml" or "study/training.yaml". All functions throw ConfigError.
class ConfigFolder {
 public:
  ConfigFolder() = default;
  /// Without an overlay, or with one that is the same folder, `complete` alone is read.
  ConfigFolder(std::string complete, const std::string& overlay = "");
  ConfigFolder(const char* complete) : ConfigFolder(std::string(complete)) {}

  /// The merged file. A missing file and malformed YAML throw.
  Section open(const std::string& file) const;
  /// The text of the file, byte for byte, if no overlay changes it; else the merged file as YAML.
  std::string text(const std::string& file) const;
  /// The same with these of its mappings alone. Throws for a file that lacks one of them.
  std::string textOfSections(const std::string& file, const std::vector<std::string>& keys) const;
  /// All values of the merged file: the same text for the same values, whatever their order,
  /// comments and layout.
  std::string values(const std::string& file) const;
  /// The names of the files with configuration in the complete folder, or in a `part` of it as
  /// "study", ascending.
  std::vector<std::string> files(const std::string& part = "") const;

  /// Throws if the overlay is no folder, or has a .yaml file that the complete folder lacks.
  /// Mappings of topics ("topics_NAME.yaml") may have any name.
  void check() const;

 private:
  std::string complete_;
  std::string overlay_;
};

}  // namespace forge
