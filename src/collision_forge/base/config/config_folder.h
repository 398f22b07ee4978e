#pragma once

#include <string>
#include <vector>

#include "collision_forge/base/config/section.h"

namespace forge {

/// A folder of configuration files with an optional overlay. If both folders have a file, mappings
/// are merged key by key and other values of the overlay replace the values of the complete folder.
/// A relative path is resolved against the folder of the file that gives it; a value that the
/// overlay merely repeats counts as given by the complete folder.
///
/// File names are like "search.yaml" or "study/training.yaml". All functions throw ConfigError.
class ConfigFolder {
 public:
  /// A placeholder in structs, to be assigned before any member is called.
  ConfigFolder() = default;
  /// `complete` and `overlay` are paths of folders. Uses `complete` alone if `overlay` is empty or
  /// the same folder. Does not throw for a missing folder; see check() and open().
  ConfigFolder(std::string complete, const std::string& overlay = "");
  /// As above, without an overlay.
  ConfigFolder(const char* complete) : ConfigFolder(std::string(complete)) {}

  /// Opens the merged file as a Section without a name. Throws if the complete folder lacks the
  /// file, or if a file is not valid YAML.
  Section open(const std::string& file) const;
  /// Returns the file's text, byte for byte, if no overlay changes it; else the merged file as
  /// YAML.
  std::string text(const std::string& file) const;
  /// Returns the top-level mappings `keys` of the merged file as YAML, in the order of `keys`.
  /// Throws if one is missing.
  std::string textOfSections(const std::string& file, const std::vector<std::string>& keys) const;
  /// Returns all values of the merged file as one text that does not depend on the order of keys,
  /// comments or layout (the order in lists counts): equal configurations give equal texts. Values
  /// are compared as written: 1.0 and 1 differ.
  std::string values(const std::string& file) const;
  /// Returns the sorted names of the .yaml files in the complete folder, or in its subfolder `part`
  /// (for example "study", names like "study/training.yaml"); empty if there is no such folder.
  std::vector<std::string> files(const std::string& part = "") const;

  /// Throws if the overlay is not a folder, or if it or one of its subfolders "catalogue" and
  /// "study" has a .yaml file that the complete folder lacks. Topic mappings ("topics_NAME.yaml")
  /// may have any name.
  void check() const;

 private:
  std::string complete_;
  std::string overlay_;
};

}  // namespace forge
