#include <vector>

#include "collision_forge/ros/bag_reader.h"
#include "collision_forge/ros/foreign_bag.h"
#include "fuzz/reading.h"
#include "fuzz/targets.h"

namespace forge {

/// A bag, of this suite or of others.
bool fuzzBags(const std::string& input) {
  static const TopicMapping mapping =
      readTopicMapping(COLLISION_FORGE_SOURCE_DIR "/config/topics_derived_object.yaml");
  const InputFolder folder;
  const std::string path = folder.write("input.bag", input);
  const Config& config = configuration();
  std::vector<std::string> warnings;
  const bool is_ours = isTaken("input", [&] {
    Scene scene = readBag(path, config.ego_vehicle, &warnings);
    checkScene(scene, config.input_limits, path, &warnings);
  });
  const bool is_attacked = isTaken(path, [&] {
    const Scenario scenario = readAttack(path, config.ego_vehicle, config.crash);
    checkTrajectory(scenario.answer.trajectory, config.input_limits, path);
  });
  const bool is_foreign =
      isTaken(path, [&] { readForeignBag(path, mapping, config.ego_vehicle, &warnings); });
  return is_ours || is_attacked || is_foreign;
}

}  // namespace forge
