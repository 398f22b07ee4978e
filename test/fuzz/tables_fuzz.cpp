#include <memory>
#include <utility>

#include "collision_forge/io/logs/log_source.h"
#include "collision_forge/io/logs/nuscenes_tables.h"
#include "fuzz/reading.h"
#include "fuzz/targets.h"

namespace forge {

/// Input: the tables of a nuScenes root, one part each.
bool fuzzTables(const std::string& input) {
  const InputFolder folder;
  for (const auto& [name, table] : partsOf(input)) folder.write(name + ".json", table);
  const auto lanes = std::make_shared<const LaneIndex>(std::make_shared<const LaneMap>());
  SceneReading reading;
  reading.options = configuration();
  return isTaken("", [&] {
    const NuScenesRoot root(folder.path(), ".");
    for (const std::string& name : root.sceneNames()) {
      NuScenesRecording recording = root.readScene(name);
      keepWithin(recording, reading.options, nullptr);
      flattened({std::move(recording), lanes}, reading);
    }
  });
}

}  // namespace forge
