#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision_forge/io/logs/nuscenes_json.h"
#include "collision_forge/io/logs/nuscenes_recording.h"
#include "collision_forge/io/logs/nuscenes_rows.h"

namespace forge {

struct NuScenesReadOptions {
  std::vector<std::string> only;  ///< names of the scenes to read; all when empty
  NuScenesProgress on_progress;   ///< called every few megabytes, if set
};

/// The tables under DATAROOT/VERSION, read once and held in memory in short form (300 bytes an
/// annotation or less); recordings are put together on demand.
class NuScenesRoot {
 public:
  /// Throws NuScenesError as readNuScenesTables() does, and for a folder that does not exist.
  NuScenesRoot(const std::string& dataroot, const std::string& version,
               const NuScenesReadOptions& options = {});

  /// Of the scenes read, in the table's order.
  std::vector<std::string> sceneNames() const;

  /// Throws NuScenesError when no such scene was read, when it has no samples or no ego poses, and
  /// when two of them, or two annotations of one instance, are of the same instant.
  NuScenesRecording readScene(const std::string& name) const;

 private:
  std::shared_ptr<const NuScenesTables> tables_;
};

}  // namespace forge
