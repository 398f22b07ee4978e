#include <memory>

#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/io/maps/map_file.h"
#include "fuzz/reading.h"
#include "fuzz/targets.h"

namespace forge {

/// Input: a Lanelet2 map.
bool fuzzLanelets(const std::string& input) {
  const InputFolder folder;
  const std::string path = folder.write("town.osm", input);
  return isTaken(path, [&] {
    const LaneIndex index(std::make_shared<const LaneMap>(readMapFile(path, configuration())));
  });
}

}  // namespace forge
