#include "collision_forge/io/maps/common_road_logs.h"
#include "fuzz/reading.h"
#include "fuzz/targets.h"

namespace forge {

/// Input: a CommonRoad scenario.
bool fuzzCommonroad(const std::string& input) {
  const InputFolder folder;
  const std::string path = folder.write("town.xml", input);
  return isTaken("town", [&] {
    const StudyConfig& config = configuration();
    const LoggedScene logged = readCommonRoadScenario(path, "", config);
    const Scene scene = flattened(logged, {{}, config, {}, {}}).scene;
    for (std::size_t i = 1; i < scene.ego.states.size(); ++i) {
      require(scene.ego.states[i].time > scene.ego.states[i - 1].time, "times of the ego increase");
    }
  });
}

}  // namespace forge
