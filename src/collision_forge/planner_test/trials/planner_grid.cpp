#include "collision_forge/planner_test/trials/planner_grid.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <set>
#include <sstream>
#include <tuple>

#include "collision_forge/base/config/config_file.h"
#include "collision_forge/base/config/config_folder.h"

namespace forge {
namespace {

/// A number in a text with its position.
struct NumberPlace {
  int line = 0;    ///< from 0 on
  int column = 0;  ///< from 0 on
  std::string text;
  double value = 0.0;
};

YAML::Node parse(const std::string& path, const std::string& text) {
  try {
    return YAML::Load(text);
  } catch (const YAML::Exception& error) {
    throw ConfigError(path + ": " + error.what());
  }
}

NumberPlace findNumber(const std::string& path, const YAML::Node& root, const std::string& key) {
  YAML::Node node = root;
  std::istringstream parts(key);
  for (std::string part; std::getline(parts, part, '.');) {
    if (!node.IsMap() || !node[part]) throw ConfigError(path + ": has no key " + key);
    node.reset(node[part]);
  }
  NumberPlace place;
  if (!node.IsScalar() || !YAML::convert<double>::decode(node, place.value)) {
    throw ConfigError(path + ": " + key + " is not a number");
  }
  place.line = node.Mark().line;
  place.column = node.Mark().column;
  place.text = node.Scalar();
  return place;
}

}  // namespace

PlannerGrid readPlannerGrid(const std::string& path, const std::string& planner) {
  const std::filesystem::path file(path);
  const std::string folder = file.has_parent_path() ? file.parent_path().string() : ".";
  return readPlannerGrid(openConfigFile(folder, file.filename().string()), planner);
}

PlannerGrid readPlannerGrid(Section file, const std::string& planner) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Section section = file.section(planner);
  const std::set<std::string> keys = section.unread();
  PlannerGrid grid;
  for (const std::string& key : keys) {
    std::vector<double> values = section.numbers(key, -kInfinity, kInfinity);
    if (std::set<double>(values.begin(), values.end()).size() < values.size()) {
      section.refuse(key, "lists a value twice");
    }
    grid[key] = std::move(values);
  }
  if (grid.empty()) file.refuse(planner, "has no keys");
  return grid;
}

PlannerValues readPlannerValues(const std::string& path, const std::string& text,
                                const PlannerGrid& grid) {
  const YAML::Node root = parse(path, text);
  PlannerValues values;
  for (const auto& entry : grid) {
    values[entry.first] = findNumber(path, root, entry.first).value;
  }
  return values;
}

std::string withPlannerValues(const std::string& path, const std::string& text,
                              const PlannerValues& values) {
  const YAML::Node root = parse(path, text);
  std::vector<std::pair<NumberPlace, double>> changes;
  for (const auto& [key, value] : values) {
    const NumberPlace place = findNumber(path, root, key);
    if (place.value != value) changes.emplace_back(place, value);
  }
  // Replaces from the end of each line, so that earlier columns stay valid.
  std::sort(changes.begin(), changes.end(), [](const auto& a, const auto& b) {
    return std::tie(a.first.line, a.first.column) > std::tie(b.first.line, b.first.column);
  });
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  for (const auto& [place, value] : changes) {
    std::string& line = lines[place.line];
    if (line.compare(place.column, place.text.size(), place.text) != 0) {
      throw ConfigError(path + ": line " + std::to_string(place.line + 1) + ": the number " +
                        place.text + " is in quotes; write it without them");
    }
    line.replace(place.column, place.text.size(), shortestText(value));
  }
  std::string changed;
  for (const std::string& line : lines) changed += line + '\n';
  return changed;
}

TrialOptions readTrialOptions(const std::string& path, const std::string& text,
                              const PlannerValues& values, const VehicleLimits& limits) {
  TrialOptions options, unchanged;
  readConfigFile(openConfigText(path, withPlannerValues(path, text, values)), options, limits);
  readConfigFile(openConfigText(path, text), unchanged, limits);
  options.traffic = unchanged.traffic;
  return options;
}

std::string shortestText(double value) {
  char text[32];
  constexpr double kLargest = 1e15;  // integers up to this are written without an exponent
  const bool is_whole = std::floor(value) == value && std::abs(value) < kLargest;
  const auto end = is_whole
                       ? std::to_chars(text, text + sizeof(text), value, std::chars_format::fixed)
                       : std::to_chars(text, text + sizeof(text), value);
  return {text, end.ptr};
}

}  // namespace forge
