#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision_forge/io/logs/nuscenes_json.h"
#include "collision_forge/io/logs/nuscenes_recording.h"
#include "collision_forge/io/logs/nuscenes_rows.h"

namespace forge {

/// What to read of a nuScenes root.
struct NuScenesReadOptions {
  std::vector<std::string> only;  ///< names of the scenes to read; empty: all
  NuScenesProgress on_progress;   ///< called every few megabytes, if set
};

/// The tables in DATAROOT/VERSION, read once and kept in compact form (at most 300 bytes per
/// annotation); recordings are assembled on demand. Immutable, so safe to share among threads.
class NuScenesRoot {
 public:
  /// Throws NuScenesError as readNuScenesTables() does, and for a folder that does not exist.
  NuScenesRoot(const std::string& dataroot, const std::string& version,
               const NuScenesReadOptions& options = {});

  /// Returns the names of the scenes read, in the table's order.
  std::vector<std::string> sceneNames() const;

  /// Assembles a recording. Throws NuScenesError if the scene was not read, has no samples or no
  /// ego poses, or has two of them, or two annotations of one instance, at the same time.
  NuScenesRecording readScene(const std::string& name) const;

 private:
  std::shared_ptr<const NuScenesTables> tables_;
};

}  // namespace forge
