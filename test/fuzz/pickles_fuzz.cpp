#include "collision_forge/data/log_source.h"
#include "collision_forge/data/pickle_reader.h"
#include "collision_forge/data/scenario_net_logs.h"
#include "fuzz/reading.h"
#include "fuzz/targets.h"

namespace forge {

/// A scenario description of ScenarioNet.
bool fuzzPickles(const std::string& input) {
  const InputFolder folder;
  const std::string path = folder.write("sd_waymo_v1_scene.pkl", input);
  return isTaken("scene", [&] {
    SceneReading reading;
    reading.options = configuration();
    std::vector<std::string> warnings;
    flattened(readScenarioNet(path, reading.options, &warnings), reading);
  });
}

}  // namespace forge
