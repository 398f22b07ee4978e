#include "collision_forge/base/config/config_folder.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "collision_forge/base/config/nearest_names.h"
#include "collision_forge/base/config/section_layer.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

constexpr const char* kParts[] = {"", "catalogue", "study"};  // subfolders of the configuration

/// Returns a null node for a file that holds only comments.
YAML::Node load(const std::string& path) {
  try {
    return YAML::LoadFile(path);
  } catch (const YAML::Exception& error) {
    throw ConfigError(path + ": " + error.what());
  }
}

YAML::Node merged(const YAML::Node& below, const YAML::Node& above) {
  if (!below.IsMap() || !above.IsMap()) return above;
  YAML::Node both = YAML::Clone(below);
  for (const auto& entry : above) {
    const std::string key = entry.first.Scalar();
    const YAML::Node old = below[key];
    both[key] = old ? merged(old, entry.second) : entry.second;
  }
  return both;
}

std::string valueText(const YAML::Node& node) {
  if (node.IsScalar()) return node.Scalar();
  std::string text;
  if (node.IsMap()) {
    std::map<std::string, std::string> values;
    for (const auto& entry : node) values[valueText(entry.first)] = valueText(entry.second);
    for (const auto& [key, value] : values) text += key + ": " + value + ", ";
    return "{" + text + "}";
  }
  for (const YAML::Node& entry : node) text += valueText(entry) + ", ";
  return "[" + text + "]";
}

std::vector<std::string> yamlFiles(const std::string& folder, const std::string& part) {
  std::vector<std::string> names;
  const fs::path path = fs::path(folder) / part;
  if (!fs::is_directory(path)) return names;
  for (const auto& entry : fs::directory_iterator(path)) {
    if (entry.path().extension() != ".yaml") continue;
    names.push_back((fs::path(part) / entry.path().filename()).string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string readAll(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  content << file.rdbuf();
  if (!file) throw ConfigError(path + ": cannot be read");
  return content.str();
}

/// Returns the file of each folder that has it, the complete folder's first.
std::vector<SectionLayer> layersOf(const std::string& complete, const std::string& overlay,
                                   const std::string& file) {
  std::vector<SectionLayer> layers = {{complete + "/" + file, load(complete + "/" + file)}};
  const std::string above = overlay + "/" + file;
  if (overlay.empty() || !fs::exists(above)) return layers;
  const YAML::Node node = load(above);
  if (!node.IsNull()) layers.push_back({above, node});
  return layers;
}

YAML::Node mergedFile(const std::string& complete, const std::string& overlay,
                      const std::string& file) {
  const std::vector<SectionLayer> layers = layersOf(complete, overlay, file);
  return layers.size() == 1 ? layers.front().node : merged(layers.front().node, layers.back().node);
}

/// Returns a hint with the same file name in another part, or else the most similar name.
std::string hintFor(const std::string& file, const std::vector<std::string>& names) {
  const fs::path path(file);
  for (const std::string& name : names) {
    if (fs::path(name).filename() == path.filename()) return "; did you mean " + name + "?";
  }
  return nearestNameHint(file, names);
}

}  // namespace

ConfigFolder::ConfigFolder(std::string complete, const std::string& overlay)
    : complete_(std::move(complete)) {
  std::error_code absent;
  if (!overlay.empty() && !fs::equivalent(complete_, overlay, absent)) overlay_ = overlay;
}

Section ConfigFolder::open(const std::string& file) const {
  return {"", layersOf(complete_, overlay_, file)};
}

std::string ConfigFolder::text(const std::string& file) const {
  const std::vector<SectionLayer> layers = layersOf(complete_, overlay_, file);
  if (layers.size() == 1) return readAll(layers.front().file);
  return YAML::Dump(merged(layers.front().node, layers.back().node)) + "\n";
}

std::string ConfigFolder::textOfSections(const std::string& file,
                                         const std::vector<std::string>& keys) const {
  const YAML::Node all = mergedFile(complete_, overlay_, file);
  YAML::Node chosen;
  for (const std::string& key : keys) {
    if (!all[key]) throw ConfigError(complete_ + "/" + file + ": " + key + " is missing");
    chosen[key] = all[key];
  }
  return YAML::Dump(chosen) + "\n";
}

std::string ConfigFolder::values(const std::string& file) const {
  return valueText(mergedFile(complete_, overlay_, file));
}

std::vector<std::string> ConfigFolder::files(const std::string& part) const {
  return yamlFiles(complete_, part);
}

void ConfigFolder::check() const {
  if (overlay_.empty()) return;
  if (!fs::is_directory(overlay_)) throw ConfigError(overlay_ + ": is not a folder");
  std::vector<std::string> known;
  for (const char* part : kParts) {
    for (std::string& name : yamlFiles(complete_, part)) known.push_back(std::move(name));
  }
  for (const char* part : kParts) {
    for (const std::string& name : yamlFiles(overlay_, part)) {
      const bool is_known = std::find(known.begin(), known.end(), name) != known.end();
      if (is_known || name.rfind("topics_", 0) == 0) continue;
      throw ConfigError(overlay_ + "/" + name + ": is not a file of the configuration in " +
                        complete_ + hintFor(name, known));
    }
  }
}

}  // namespace forge
