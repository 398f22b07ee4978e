#include "collision_forge/data/scene_source.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "collision_forge/data/nuscenes_json.h"

namespace forge {

std::vector<std::string> readSceneNames(const std::string& dataroot, const std::string& version) {
  constexpr std::size_t kName = 1;  // position among the fields read
  std::vector<std::string> names;
  readTable(dataroot + "/" + version + "/scene.json", {"token", "name"},
            [&](const JsonRow& row) { names.emplace_back(row.text(kName)); });
  return names;
}

SceneSource::SceneSource(const std::string& dataroot, const std::string& version,
                         const std::vector<std::string>& scenes, const DataOptions& options,
                         std::size_t kept, OnWarnings on_warnings,
                         const NuScenesProgress& on_progress)
    : ego_vehicle_(options.ego_vehicle),
      root_(dataroot, version, {scenes, on_progress}),
      kept_(kept),
      on_warnings_(std::move(on_warnings)),
      maps_(dataroot, options, on_warnings_) {}

std::shared_ptr<const IndexedScene> SceneSource::at(const std::string& name) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = std::find_if(scenes_.begin(), scenes_.end(),
                                  [&](const auto& held) { return held->scene.name == name; });
  if (found != scenes_.end()) {
    scenes_.splice(scenes_.begin(), scenes_, found);
  } else {
    scenes_.push_front(read(name));
    if (scenes_.size() > kept_) scenes_.pop_back();
  }
  return scenes_.front();
}

std::shared_ptr<const IndexedScene> SceneSource::read(const std::string& name) {
  const NuScenesRecording recording = root_.readScene(name);
  const auto lanes = maps_.at(recording.location);
  std::vector<std::string> warnings;
  Scene scene = toScene(recording, ego_vehicle_, lanes->sharedMap(), &warnings);
  if (on_warnings_ && !warnings.empty()) on_warnings_(name, warnings);
  return std::make_shared<const IndexedScene>(IndexedScene{std::move(scene), lanes});
}

}  // namespace forge
