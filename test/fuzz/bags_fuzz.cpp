#include <vector>

#include "collision_forge/ros/bags/bag_reader.h"
#include "collision_forge/ros/bags/foreign_bag.h"
#include "collision_forge/ros/bags/log_sources.h"
#include "collision_forge/ros/bags/mcap_export.h"
#include "fuzz/reading.h"
#include "fuzz/targets.h"

namespace forge {
namespace {

TopicMapping mappingOfObjects() {
  return readTopicMapping(COLLISION_FORGE_SOURCE_DIR "/config/topics_derived_object.yaml");
}

/// Returns a mapping with the ego's pose from a chain of transforms, and agents in any frame.
TopicMapping mappingOfTransforms() {
  TopicMapping mapping = mappingOfObjects();
  mapping.map_frame = "world";
  mapping.ego.fields.topic = "/tf";
  mapping.ego.fields.type = "tf2_msgs/TFMessage";
  mapping.ego.in_transforms = true;
  mapping.agents.fields.frame_id.clear();
  return mapping;
}

}  // namespace

/// Input: a bag of this suite or of another stack.
bool fuzzBags(const std::string& input) {
  static const TopicMapping objects = mappingOfObjects();
  static const TopicMapping transforms = mappingOfTransforms();
  const InputFolder folder;
  const std::string path = folder.write("input.bag", input);
  const Config& config = configuration();
  std::vector<std::string> warnings;
  const bool is_ours = isTaken("input", [&] { readBag(path, config, &warnings); });
  const bool is_source = isTaken("input", [&] {
    const LogSource source{path, "", &bagFormat()};
    source.format->open(source, {{}, config, {}, {}})->read("input");
  });
  const bool is_attacked = isTaken(path, [&] { readAttack(path, config, config.crash); });
  const auto isTakenBy = [&](const TopicMapping& mapping) {
    return isTaken(path, [&] {
      NuScenesRecording recording = readForeignBag(path, mapping, config.ego_vehicle, &warnings);
      keepWithin(recording, config, &warnings);
    });
  };
  const bool is_foreign = isTakenBy(objects);
  const bool is_chained = isTakenBy(transforms);
  const bool is_copied =
      isTaken(path, [&] { exportToMcap(path, folder.path() + "/output.mcap", config); });
  isTaken(path,
          [&] { exportToMcap(path, folder.path() + "/ros2.mcap", config, McapProfile::kRos2); });
  return is_ours || is_source || is_attacked || is_foreign || is_chained || is_copied;
}

}  // namespace forge
