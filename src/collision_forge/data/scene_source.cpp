#include "collision_forge/data/scene_source.h"

#include <algorithm>
#include <utility>

namespace forge {

SceneSource::SceneSource(const LogSource& source, const std::vector<std::string>& scenes,
                         const DataOptions& options, std::size_t kept, OnWarnings on_warnings,
                         const NuScenesProgress& on_progress)
    : reader_(source.format->open(source, {scenes, options, std::move(on_warnings), on_progress})),
      kept_(kept) {}

std::shared_ptr<const IndexedScene> SceneSource::at(const std::string& name) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = std::find_if(scenes_.begin(), scenes_.end(),
                                  [&](const auto& held) { return held->scene.name == name; });
  if (found != scenes_.end()) {
    scenes_.splice(scenes_.begin(), scenes_, found);
  } else {
    scenes_.push_front(std::make_shared<const IndexedScene>(reader_->read(name)));
    if (scenes_.size() > kept_) scenes_.pop_back();
  }
  return scenes_.front();
}

}  // namespace forge
