#pragma once

#include <yaml-cpp/yaml.h>

#include <limits>
#include <set>
#include <string>
#include <vector>

#include "collision_forge/config/config_error.h"
#include "collision_forge/drawing/drawing_options.h"
#include "collision_forge/map/lane_map.h"
#include "collision_forge/scene/crash_definition.h"

namespace forge {

/// One mapping of a configuration file, for the sources that read config/. Every read checks the
/// value; finish() finds the keys that nobody read. All throw ConfigError.
class Section {
 public:
  Section(std::string file, std::string name, const YAML::Node& node);

  Section section(const std::string& key);

  double positive(const std::string& key);
  double within(const std::string& key, double min, double max);
  double nonNegative(const std::string& key);
  int count(const std::string& key, int min, int max = std::numeric_limits<int>::max());
  std::vector<double> positives(const std::string& key);
  /// One or more numbers, each within the range.
  std::vector<double> numbers(const std::string& key, double min, double max);
  /// Two or more numbers from 0 to 1, none below the one before.
  std::vector<double> risingShares(const std::string& key);
  /// [red, green, blue], each 0 to 1.
  Color color(const std::string& key);
  TypeRules typeRules(const std::string& key);
  std::string text(const std::string& key);
  std::vector<std::string> texts(const std::string& key);
  DrivingSide drivingSide(const std::string& key);

  /// Throws the error of a value that the section cannot check.
  [[noreturn]] void refuse(const std::string& key, const std::string& problem) const;

  /// Keys that were not read yet.
  const std::set<std::string>& unread() const { return unread_; }

  void finish() const;

 private:
  std::string pathOf(const std::string& key) const;
  [[noreturn]] void fail(const std::string& path, const YAML::Node& node,
                         const std::string& problem) const;
  YAML::Node take(const std::string& key);
  double toNumber(const std::string& key, const YAML::Node& node) const;

  std::string file_;
  std::string name_;
  const YAML::Node node_;
  std::set<std::string> unread_;
};

/// The whole of one file of config/.
Section openConfigFile(const std::string& directory, const std::string& name);

/// The same of a file's text; `path` is what errors name.
Section openConfigText(const std::string& path, const std::string& text);

}  // namespace forge
