#include "collision_forge/io/export/scenario_net_description.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/base/files/plain_name.h"
#include "collision_forge/io/export/drivable_edge.h"
#include "collision_forge/io/export/scenario_net_map.h"

namespace forge {
namespace {

// Parts of the file names that the format prescribes.
constexpr const char* kDataset = "collision_forge";
constexpr const char* kVersion = "v1";
constexpr const char* kEnding = ".pkl";

std::string beginOfFiles() { return std::string("sd_") + kDataset + "_" + kVersion + "_"; }

void writeNumberSummary(PickleWriter& metadata, const ScenarioDescription& scenario,
                        std::size_t features) {
  metadata.beginObject("number_summary");
  writeObjectNumbers(metadata, scenario.table);
  writeLightNumbers(metadata, scenario.lights, scenario.table.times);
  metadata.count("num_map_features", features);
  metadata.number("map_height_diff", 0.0);
  metadata.endObject();
}

void writeMetadata(PickleWriter& metadata, const ScenarioDescription& scenario,
                   std::size_t features) {
  metadata.beginObject("metadata");
  metadata.text("dataset", kDataset);
  metadata.text("id", scenario.name);
  metadata.text("scenario_id", scenario.name);
  metadata.text("map", scenario.map.location);
  metadata.text("coordinate", "metadrive");
  metadata.flag("metadrive_processed", false);
  if (scenario.step) metadata.number("sample_rate", *scenario.step);
  metadata.array("ts", scenario.table.times);
  metadata.count("current_time_index", scenario.current_row);
  metadata.text("sdc_id", scenario.table.tracks.front().id);
  writeObjectSummary(metadata, scenario.table);
  writeNumberSummary(metadata, scenario, features);
  metadata.beginObject("collision_forge");
  scenario.write_own(metadata);
  writeGround(metadata, scenario.map);
  metadata.endObject();
  metadata.endObject();
}

}  // namespace

PickleContent describe(const ScenarioDescription& scenario, const std::vector<Vector2>& path_points,
                       const ExportOptions& options) {
  PickleWriter writer;
  writer.text("id", scenario.name);
  writer.text("version", kVersion);
  writer.count("length", scenario.table.times.size());
  writeTracks(writer, scenario.table);
  writeLights(writer, scenario.lights, scenario.table.times);
  const auto& recorded = scenario.map.features;
  const bool has_edges =
      std::any_of(recorded.begin(), recorded.end(),
                  [](const MapFeature& feature) { return isRoadEdge(feature.kind); });
  const std::size_t features = writeMapFeatures(
      writer, scenario.map,
      has_edges ? std::vector<std::vector<Vector2>>()
                : drivableEdges(scenario.map.drivable_area, path_points, options.radius));
  writeMetadata(writer, scenario, features);
  return writer.content();
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

void writeScenarioNetSummary(const std::string& folder, const std::vector<std::string>& names,
                             PickleWorkers& workers) {
  std::vector<std::pair<std::string, std::string>> files;
  PickleWriter folders;
  for (const std::string& name : names) {
    const std::string file = scenarioNetFile(name);
    files.emplace_back(file, pathIn(folder, file));
    folders.text(file.c_str(), "");
  }
  writeText(pathIn(folder, "dataset_summary.pkl"), workers.summarize(files));
  writeText(pathIn(folder, "dataset_mapping.pkl"), workers.write(folders.content()));
}

}  // namespace forge
