#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision_forge/io/logs/nuscenes_json.h"
#include "collision_forge/io/logs/nuscenes_recording.h"
#include "collision_forge/io/logs/nuscenes_rows.h"

namespace forge {

/// Selection of the scenes to read from a nuScenes root.
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

  /// Returns the names of the selected scenes, in the table's order.
  std::vector<std::string> sceneNames() const;

  /// Assembles a recording, with derived velocities (deriveVelocities()). Throws NuScenesError if
  /// the scene does not exist or was not selected, has no samples or no ego poses, or has two ego
  /// poses or two samples at the same time, or two annotations of one instance in the same sample.
  NuScenesRecording readScene(const std::string& name) const;

 private:
  std::shared_ptr<const NuScenesTables> tables_;
};

}  // namespace forge
