#include "collision_forge/base/config/section.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <utility>

namespace forge {
namespace {

std::string textOf(const YAML::Node& node) {
  return node.IsScalar() ? node.Scalar() : YAML::Dump(node);
}

std::string rangeText(double min, double max) {
  std::ostringstream text;
  text << "is not within " << min << " to " << max;
  return text.str();
}

}  // namespace

Section::Section(std::string file, std::string name, const YAML::Node& node)
    : file_(std::move(file)),
      name_(std::move(name)),
      node_(std::make_shared<const YAML::Node>(node)) {
  if (!node.IsMap()) fail(name_.empty() ? "the file" : name_, node, "is not a mapping");
  for (const auto& entry : node) {
    if (!entry.first.IsScalar()) fail(pathOf(textOf(entry.first)), entry.second, "has no name");
    const std::string key = entry.first.Scalar();
    if (!unread_.insert(key).second) fail(pathOf(key), entry.second, "is given twice");
  }
}

Section Section::section(const std::string& key) { return {file_, pathOf(key), take(key)}; }

double Section::positive(const std::string& key) {
  const YAML::Node node = take(key);
  const double value = toNumber(key, node);
  if (!(value > 0.0)) fail(pathOf(key), node, "is not positive");
  return value;
}

double Section::within(const std::string& key, double min, double max) {
  const YAML::Node node = take(key);
  const double value = toNumber(key, node);
  if (!(value >= min && value <= max)) fail(pathOf(key), node, rangeText(min, max));
  return value;
}

double Section::atLeast(const std::string& key, double min) {
  return within(key, min, std::numeric_limits<double>::infinity());
}

int Section::count(const std::string& key, int min, int max) {
  const YAML::Node node = take(key);
  int value = 0;
  if (!YAML::convert<int>::decode(node, value)) fail(pathOf(key), node, "is not an integer");
  if (value < min || value > max) fail(pathOf(key), node, rangeText(min, max));
  return value;
}

std::vector<double> Section::positives(const std::string& key) {
  const YAML::Node node = take(key);
  if (!node.IsSequence() || node.size() == 0) fail(pathOf(key), node, "is not a list of numbers");
  std::vector<double> values;
  for (const YAML::Node& entry : node) {
    values.push_back(toNumber(key, entry));
    if (!(values.back() > 0.0)) fail(pathOf(key), entry, "is not positive");
  }
  return values;
}

std::vector<double> Section::numbers(const std::string& key, double min, double max) {
  const YAML::Node node = take(key);
  if (!node.IsSequence() || node.size() == 0) fail(pathOf(key), node, "is not a list of numbers");
  std::vector<double> values;
  for (const YAML::Node& entry : node) {
    values.push_back(toNumber(key, entry));
    if (!(values.back() >= min && values.back() <= max)) {
      fail(pathOf(key), entry, rangeText(min, max));
    }
  }
  return values;
}

std::vector<double> Section::risingShares(const std::string& key) {
  const YAML::Node node = take(key);
  if (!node.IsSequence() || node.size() < 2) fail(pathOf(key), node, "is not a list of numbers");
  std::vector<double> values;
  for (const YAML::Node& entry : node) {
    const double value = toNumber(key, entry);
    if (!(value >= 0.0 && value <= 1.0)) fail(pathOf(key), entry, rangeText(0.0, 1.0));
    if (!values.empty() && value < values.back()) {
      fail(pathOf(key), entry, "is below the one before");
    }
    values.push_back(value);
  }
  return values;
}

std::vector<double> Section::colorShares(const std::string& key) {
  const YAML::Node node = take(key);
  if (!node.IsSequence() || node.size() != 3) {
    fail(pathOf(key), node, "is not [red, green, blue]");
  }
  std::vector<double> shares;
  for (const YAML::Node& entry : node) {
    shares.push_back(toNumber(key, entry));
    if (!(shares.back() >= 0.0 && shares.back() <= 1.0)) {
      fail(pathOf(key), node, rangeText(0.0, 1.0));
    }
  }
  return shares;
}

std::size_t Section::indexOf(const std::string& key, const std::vector<std::string>& names) {
  const YAML::Node node = take(key);
  const auto found = std::find(names.begin(), names.end(), textOf(node));
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  std::string known;
  for (const std::string& name : names) known += (known.empty() ? "" : ", ") + name;
  fail(pathOf(key), node, "is none of " + known);
}

std::string Section::text(const std::string& key) {
  const YAML::Node node = take(key);
  if (!node.IsScalar()) fail(pathOf(key), node, "is not a text");
  return node.Scalar();
}

std::string Section::path(const std::string& key) {
  const std::string file = text(key);
  return file.empty() ? file : seenFromFolder(file);
}

std::vector<std::string> Section::paths(const std::string& key) {
  const YAML::Node node = take(key);
  if (!node.IsSequence()) fail(pathOf(key), node, "is not a list of paths");
  std::vector<std::string> files;
  for (const YAML::Node& entry : node) {
    if (!entry.IsScalar() || entry.Scalar().empty()) fail(pathOf(key), entry, "is not a path");
    files.push_back(seenFromFolder(entry.Scalar()));
  }
  return files;
}

void Section::refuse(const std::string& key, const std::string& problem) const {
  throw ConfigError(file_ + ": " + pathOf(key) + ": " + problem);
}

void Section::finish() const {
  if (unread_.empty()) return;
  const std::string& key = *unread_.begin();
  fail(pathOf(key), (*node_)[key], "is an unknown key");
}

std::string Section::seenFromFolder(const std::string& file) const {
  return std::filesystem::path(file_).parent_path() / file;
}

std::string Section::pathOf(const std::string& key) const {
  return name_.empty() ? key : name_ + "." + key;
}

void Section::fail(const std::string& path, const YAML::Node& node,
                   const std::string& problem) const {
  throw ConfigError(file_ + ": " + path + " = " + textOf(node) + " " + problem);
}

YAML::Node Section::take(const std::string& key) {
  if (unread_.erase(key) == 0) throw ConfigError(file_ + ": " + pathOf(key) + " is missing");
  return (*node_)[key];
}

double Section::toNumber(const std::string& key, const YAML::Node& node) const {
  double value = 0.0;
  if (!YAML::convert<double>::decode(node, value)) fail(pathOf(key), node, "is not a number");
  if (!std::isfinite(value)) fail(pathOf(key), node, "is not finite");
  return value;
}

Section openConfigFile(const std::string& directory, const std::string& name) {
  const std::string path = directory + "/" + name;
  try {
    return {path, "", YAML::LoadFile(path)};
  } catch (const YAML::Exception& error) {
    throw ConfigError(path + ": " + error.what());
  }
}

Section openConfigText(const std::string& path, const std::string& text) {
  try {
    return {path, "", YAML::Load(text)};
  } catch (const YAML::Exception& error) {
    throw ConfigError(path + ": " + error.what());
  }
}

std::string textOfSections(const std::string& path, const std::vector<std::string>& keys) {
  try {
    const YAML::Node all = YAML::LoadFile(path);
    YAML::Node chosen;
    for (const std::string& key : keys) {
      if (!all[key]) throw ConfigError(path + ": " + key + " is missing");
      chosen[key] = all[key];
    }
    return YAML::Dump(chosen) + "\n";
  } catch (const YAML::Exception& error) {
    throw ConfigError(path + ": " + error.what());
  }
}

}  // namespace forge
