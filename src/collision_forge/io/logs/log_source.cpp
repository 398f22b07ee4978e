#include "collision_forge/io/logs/log_source.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <unordered_set>
#include <utility>

#include "collision_forge/base/scene/input_limits.h"
#include "collision_forge/io/logs/log_fingerprints.h"
#include "collision_forge/io/logs/nuscenes_json.h"
#include "collision_forge/io/logs/nuscenes_tables.h"
#include "collision_forge/io/logs/recording_repair.h"
#include "collision_forge/io/logs/unknown_source.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

constexpr const char* kScenes = "scene.json";

/// Returns the names of the folders that have tables, sorted.
std::vector<std::string> versionsIn(const std::string& path) {
  std::vector<std::string> found;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(path, ignored)) {
    if (fs::exists(entry.path() / kScenes)) found.push_back(entry.path().filename().string());
  }
  std::sort(found.begin(), found.end());
  return found;
}

bool isNuScenesRoot(const std::string& path) { return fs::is_directory(fs::path(path) / "maps"); }

std::vector<std::string> namesIn(const LogSource& source) {
  constexpr std::size_t kName = 1;  // index in the list of fields
  std::vector<std::string> names;
  readTable(source.path + "/" + versionOf(source) + "/" + kScenes, {"token", "name"},
            [&](const JsonRow& row) { names.emplace_back(row.text(kName)); });
  return names;
}

/// Shifts the stamps of a recording that does not begin after 0 so that it begins at 1 s, because a
/// bag cannot hold time 0.
void shiftToPositive(NuScenesRecording& recording, std::vector<std::string>& warnings) {
  constexpr std::int64_t kBegin = 1000000;  // us
  if (recording.ego_poses.empty() || recording.frames.empty()) return;
  const std::int64_t first =
      std::min(recording.ego_poses.front().timestamp_us, recording.frames.front().timestamp_us);
  if (first > 0) return;
  for (NuScenesEgoPose& pose : recording.ego_poses) pose.timestamp_us += kBegin - first;
  for (NuScenesFrame& frame : recording.frames) frame.timestamp_us += kBegin - first;
  warnings.push_back("timestamps begin at " + std::to_string(first) +
                     " us: shifted to begin at 1 s");
}

class NuScenesReader : public SceneReader {
 public:
  NuScenesReader(const LogSource& source, SceneReading reading)
      : reading_(std::move(reading)),
        root_(source.path, versionOf(source), {reading_.scenes, reading_.on_progress}),
        maps_(source.path, reading_.options, reading_.on_warnings) {}

  std::vector<std::string> names() const override { return root_.sceneNames(); }

  LoggedScene recording(const std::string& name) override {
    NuScenesRecording found = root_.readScene(name);
    std::vector<std::string> warnings;
    shiftToPositive(found, warnings);
    keepWithin(found, reading_.options, &warnings);
    if (reading_.on_warnings && !warnings.empty()) reading_.on_warnings(name, warnings);
    auto lanes = maps_.at(found.location);
    return {std::move(found), std::move(lanes)};
  }

  IndexedScene read(const std::string& name) override {
    return flattened(recording(name), reading_);
  }

 private:
  SceneReading reading_;
  NuScenesRoot root_;
  CityMaps maps_;
};

std::unique_ptr<SceneReader> openNuScenes(const LogSource& source, const SceneReading& reading) {
  return std::make_unique<NuScenesReader>(source, reading);
}

}  // namespace

const LogFormat& nuScenesFormat() {
  static const LogFormat format{"a nuScenes root", isNuScenesRoot, namesIn, openNuScenes};
  return format;
}

std::string versionOf(const LogSource& source) {
  if (!source.version.empty()) return source.version;
  const std::vector<std::string> found = versionsIn(source.path);
  if (found.size() == 1) return found.front();
  if (found.empty()) {
    throw NuScenesError(unknownSourceText(source.path));
  }
  std::string names;
  for (const std::string& name : found) names += (names.empty() ? "" : ", ") + name;
  throw NuScenesError(source.path +
                      ": has tables of several versions; choose one with --version: " + names);
}

std::map<std::string, std::string> fingerprintsOf(const LogSource& source) {
  std::string version = source.version;
  if (version.empty() && source.format == &nuScenesFormat()) {
    const std::vector<std::string> found = versionsIn(source.path);
    if (found.size() == 1) version = found.front();
  }
  std::map<std::string, std::string> fingerprints = logFingerprints(source.path, version);
  fingerprints["source"] = fs::canonical(source.path).string();
  if (!version.empty()) fingerprints["version"] = version;
  if (!source.ego.empty()) fingerprints["ego"] = source.ego;
  return fingerprints;
}

std::string LogSource::title() const {
  if (!version.empty()) return version;
  const fs::path normal = fs::path(path).lexically_normal();
  return (normal.has_filename() ? normal : normal.parent_path()).filename().string();
}

void keepWithin(NuScenesRecording& recording, const DataOptions& options,
                std::vector<std::string>* warnings) {
  repair(recording, options, warnings);
  Scene scene = toScene(recording, options.ego_vehicle, nullptr);
  const std::size_t before = scene.agents.size();
  checkScene(scene, options.input_limits, recording.name, warnings);
  if (scene.agents.size() == before) return;
  std::unordered_set<std::string> kept;
  for (const Track& agent : scene.agents) kept.insert(agent.id);
  for (NuScenesFrame& frame : recording.frames) {
    auto& annotations = frame.annotations;
    annotations.erase(std::remove_if(annotations.begin(), annotations.end(),
                                     [&](const auto& annotation) {
                                       return kept.count(annotation.instance) == 0;
                                     }),
                      annotations.end());
  }
}

IndexedScene flattened(const LoggedScene& logged, const SceneReading& reading) {
  return {toScene(logged.recording, reading.options.ego_vehicle, logged.lanes->sharedMap()),
          logged.lanes};
}

std::vector<std::string> wantedScenes(const LogSource& source,
                                      const std::vector<std::string>& wanted) {
  const std::vector<std::string> known = readSceneNames(source);
  if (wanted.empty()) return known;
  for (const std::string& name : wanted) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    throw std::runtime_error(source.described() + ": has no scene \"" + name + "\"");
  }
  std::vector<std::string> found;
  for (const std::string& name : known) {
    if (std::find(wanted.begin(), wanted.end(), name) != wanted.end()) found.push_back(name);
  }
  return found;
}

std::vector<std::string> readSceneNames(const LogSource& source) {
  return source.format->names(source);
}

}  // namespace forge
