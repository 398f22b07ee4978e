#include "collision_forge/io/logs/scene_source.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace forge {
namespace {

/// Wraps `on_warnings` so that one thread calls it at a time.
OnWarnings oneAtATime(OnWarnings on_warnings) {
  if (!on_warnings) return on_warnings;
  return [on_warnings = std::move(on_warnings), mutex = std::make_shared<std::mutex>()](
             const std::string& subject, const std::vector<std::string>& warnings) {
    const std::lock_guard<std::mutex> lock(*mutex);
    on_warnings(subject, warnings);
  };
}

}  // namespace

SceneSource::SceneSource(const LogSource& source, const std::vector<std::string>& scenes,
                         const DataOptions& options, std::size_t kept, OnWarnings on_warnings,
                         const NuScenesProgress& on_progress)
    : reader_(source.format->open(
          source, {scenes, options, oneAtATime(std::move(on_warnings)), on_progress})),
      kept_(kept) {}

std::shared_ptr<const IndexedScene> SceneSource::at(const std::string& name) {
  std::unique_lock<std::mutex> lock(mutex_);
  const auto found = std::find_if(scenes_.begin(), scenes_.end(),
                                  [&](const auto& held) { return held.first == name; });
  if (found == scenes_.end()) return read(name, lock).get();
  scenes_.splice(scenes_.begin(), scenes_, found);
  const ReadScene scene = found->second;
  lock.unlock();
  return scene.get();
}

std::vector<std::string> SceneSource::forEach(
    const std::function<void(const IndexedScene&)>& work) {
  std::vector<std::string> unreadable;
  for (const std::string& name : names()) {
    std::shared_ptr<const IndexedScene> scene;
    try {
      scene = at(name);
    } catch (const std::exception& error) {
      const std::string problem = error.what();
      unreadable.push_back(problem.rfind(name, 0) == 0 ? problem : name + ": " + problem);
      continue;
    }
    work(*scene);
  }
  return unreadable;
}

/// Reads a scene that is not cached; releases the lock while reading.
SceneSource::ReadScene SceneSource::read(const std::string& name,
                                         std::unique_lock<std::mutex>& lock) {
  std::promise<std::shared_ptr<const IndexedScene>> promise;
  ReadScene scene = promise.get_future().share();
  scenes_.emplace_front(name, scene);
  if (scenes_.size() > kept_) scenes_.pop_back();
  lock.unlock();
  try {
    promise.set_value(std::make_shared<const IndexedScene>(reader_->read(name)));
  } catch (...) {
    promise.set_exception(std::current_exception());
    lock.lock();
    scenes_.remove_if([&](const auto& held) { return held.first == name; });
    lock.unlock();
  }
  return scene;
}

std::string unreadableText(const std::vector<std::string>& problems) {
  std::string text;
  for (const std::string& problem : problems) text += "; not read: " + problem;
  return text;
}

}  // namespace forge
