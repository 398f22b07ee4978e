#include "collision_forge/export/scenario_net_description.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "collision_forge/export/drivable_edge.h"
#include "collision_forge/export/scenario_net_map.h"
#include "collision_forge/files/aside_file.h"
#include "collision_forge/files/plain_name.h"

namespace forge {
namespace {

// What the names of files are made of, as the format wants it.
constexpr const char* kDataset = "collision_forge";
constexpr const char* kVersion = "v1";
constexpr const char* kEnding = ".pkl";

constexpr const char* kMetadata = "metadata";
constexpr std::size_t kAfterMetadata = 2;  // bytes of a file: the end of its dict, and its own

std::string beginOfFiles() { return std::string("sd_") + kDataset + "_" + kVersion + "_"; }

/// What a scenario's metadata begin with.
PickleWriter begunMetadata() {
  PickleWriter metadata;
  metadata.text("dataset", kDataset);
  return metadata;
}

void writeNumberSummary(PickleWriter& metadata, const TrackTable& table, std::size_t features) {
  metadata.beginDict("number_summary");
  writeObjectNumbers(metadata, table);
  metadata.count("num_traffic_lights", 0);
  metadata.texts("num_traffic_light_types", {});
  metadata.beginDict("num_traffic_light_each_step");
  metadata.endDict();
  metadata.count("num_map_features", features);
  metadata.number("map_height_diff", 0.0);
  metadata.endDict();
}

PickleWriter metadataOf(const ScenarioDescription& scenario, std::size_t features) {
  PickleWriter metadata = begunMetadata();
  metadata.text("id", scenario.name);
  metadata.text("scenario_id", scenario.name);
  metadata.text("map", scenario.map.location);
  metadata.text("coordinate", "metadrive");
  metadata.flag("metadrive_processed", false);
  if (scenario.step) metadata.number("sample_rate", *scenario.step);
  metadata.numbers("ts", scenario.table.times);
  metadata.count("current_time_index", scenario.current_row);
  metadata.text("sdc_id", scenario.table.tracks.front().id);
  writeObjectSummary(metadata, scenario.table);
  writeNumberSummary(metadata, scenario.table, features);
  PickleWriter own = scenario.own;
  writeGround(own, scenario.map);
  metadata.value("collision_forge", own.dict());
  return metadata;
}

/// The metadata of a scenario's file as its bytes, which are the file's last.
std::string metadataIn(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  const std::string key = pickledText(kMetadata);
  std::string begin = key + begunMetadata().dict();
  begin.pop_back();  // where the dict ends
  const std::size_t place = bytes.rfind(begin);
  if (place == std::string::npos) throw std::runtime_error(path + ": is no scenario of this suite");
  const std::size_t from = place + key.size();
  return bytes.substr(from, bytes.size() - kAfterMetadata - from);
}

}  // namespace

std::string pickledScenario(const ScenarioDescription& scenario, const std::vector<Vector2>& ways,
                            const ExportOptions& options) {
  PickleWriter writer;
  writer.text("id", scenario.name);
  writer.text("version", kVersion);
  writer.count("length", scenario.table.times.size());
  writeTracks(writer, scenario.table, options.heights);
  writer.beginDict("dynamic_map_states");
  writer.endDict();
  const std::size_t features = writeMapFeatures(
      writer, scenario.map, drivableEdges(scenario.map.drivable_area, ways, options.radius));
  writer.value(kMetadata, metadataOf(scenario, features).dict());
  return writer.pickle();
}

std::string scenarioNetFile(const std::string& name) { return beginOfFiles() + name + kEnding; }

std::vector<std::string> scenarioNetNames(const std::string& folder) {
  const std::string begin = beginOfFiles();
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string stem = entry.path().stem().string();
    if (entry.path().extension() != kEnding || stem.compare(0, begin.size(), begin) != 0) continue;
    names.push_back(stem.substr(begin.size()));
  }
  std::sort(names.begin(), names.end());
  return names;
}

void writeScenarioNetSummary(const std::string& folder, const std::vector<std::string>& names) {
  PickleWriter summary;
  PickleWriter folders;
  for (const std::string& name : names) {
    const std::string file = scenarioNetFile(name);
    summary.value(file, metadataIn(pathIn(folder, file)));
    folders.text(file, "");
  }
  writeText(pathIn(folder, "dataset_summary.pkl"), summary.pickle());
  writeText(pathIn(folder, "dataset_mapping.pkl"), folders.pickle());
}

}  // namespace forge
