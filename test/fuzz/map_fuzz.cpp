#include <memory>
#include <vector>

#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/io/maps/map_file.h"
#include "fuzz/reading.h"
#include "fuzz/targets.h"

namespace forge {

/// Input: a map file of any format.
bool fuzzMap(const std::string& input) {
  const InputFolder folder;
  const std::string path = folder.write("boston.any", input);  // has a driving side
  return isTaken(path, [&] {
    const Config& config = configuration();
    std::vector<std::string> warnings;
    LaneMap map = readMapFile(path, config, &warnings);
    for (const Lane& lane : map.lanes) {
      for (const Pose2& pose : lane.centerline) {
        require(isWithin(pose, config.input_limits), "lane " + lane.id + " is far away");
      }
    }
    const LaneIndex index(std::make_shared<const LaneMap>(std::move(map)));
  });
}

}  // namespace forge
