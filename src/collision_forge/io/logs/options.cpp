#include "collision_forge/io/logs/options.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <utility>

#include "collision_forge/base/config/config_file.h"

namespace forge {

void readOptions(Section& section, ConversionOptions& options) {
  options.map_radius = section.positive("map_radius");
  options.centerline_resolution = section.positive("centerline_resolution");
}

void readOptions(Section& section, AttackedBagOptions& options) {
  options.frame_rate = section.within("frame_rate", 10.0, 100.0);
  options.seconds_after_stand = section.nonNegative("seconds_after_stand");
  options.end_time = section.nonNegative("end_time");
}

void readOptions(Section& section, std::map<std::string, DrivingSide>& locations) {
  while (!section.unread().empty()) {
    const std::string prefix = *section.unread().begin();
    locations[prefix] = section.choice<DrivingSide>(
        prefix, {{"right", DrivingSide::kRight}, {"left", DrivingSide::kLeft}});
  }
}

void readOptions(Section& section, std::map<std::string, AgentClass>& categories) {
  std::vector<std::pair<std::string, AgentClass>> classes;
  for (int i = 0; i <= static_cast<int>(kLastAgentClass); ++i) {
    const auto known = static_cast<AgentClass>(i);
    classes.emplace_back(toString(known), known);
  }
  while (!section.unread().empty()) {
    const std::string name = *section.unread().begin();
    categories[name] = section.choice<AgentClass>(name, classes);
  }
}

static void readOptions(Section& section, std::map<std::string, std::vector<std::string>>& files) {
  while (!section.unread().empty()) {
    const std::string name = *section.unread().begin();
    files[name] = section.paths(name);
  }
}

void readOptions(Section& section, ModelOptions& options) {
  options.non_commercial_weights =
      section.choice<bool>("non_commercial_weights", {{"true", true}, {"false", false}});
  options.pattern_network = section.path("pattern_network");
  options.speed_model = section.path("speed_model");
}

bool isNonCommercial(const std::string& file) {
  const std::filesystem::path path(file);
  std::ifstream list(path.parent_path() / "non_commercial.txt");
  for (std::string name; std::getline(list, name);) {
    if (name == path.filename()) return true;
  }
  return false;
}

std::string allowedWeights(const ModelOptions& options, const std::string& file) {
  return options.non_commercial_weights || !isNonCommercial(file) ? file : "";
}

std::map<std::string, std::vector<std::string>> generatorWeights(const ModelOptions& options) {
  std::map<std::string, std::vector<std::string>> weights;
  readConfigFile(openConfigFile(options.folder, "study/generator_weights.yaml"), weights);
  for (auto& [model, files] : weights) {
    const bool is_allowed = std::all_of(files.begin(), files.end(), [&](const std::string& file) {
      return allowedWeights(options, file) == file;
    });
    if (!is_allowed) files.clear();
  }
  return weights;
}

std::optional<DrivingSide> configuredSide(const DataOptions& options, const std::string& location) {
  const std::pair<const std::string, DrivingSide>* best = nullptr;
  for (const auto& entry : options.locations) {
    const bool fits = location.compare(0, entry.first.size(), entry.first) == 0;
    if (fits && (!best || entry.first.size() > best->first.size())) best = &entry;
  }
  return best ? std::optional(best->second) : std::nullopt;
}

DrivingSide drivingSide(const DataOptions& options, const std::string& location) {
  if (const auto side = configuredSide(options, location)) return *side;
  throw ConfigError("locations.yaml: no prefix under locations matches location = " + location +
                    "; add it with the side of the road, as \"" + location + ": right\"");
}

}  // namespace forge
