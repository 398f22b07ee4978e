#include "collision_forge/ros/bags/topic_mapping.h"

#include <charconv>
#include <cmath>
#include <filesystem>
#include <set>

#include "collision_forge/base/config/config_file.h"
#include "collision_forge/base/config/config_folder.h"
#include "collision_forge/base/scene/request_words.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {
namespace {

const std::set<std::string> kTransformTypes = {"tf2_msgs/TFMessage", "tf/tfMessage"};

/// Returns the text of a key; throws ConfigError if it is empty.
std::string wordIn(Section& section, const std::string& key) {
  std::string word = section.text(key);
  if (word.empty()) section.refuse(key, "is empty");
  return word;
}

/// Returns the number of a key, or `prefix` and the path.
NumberSource numberIn(Section& section, const std::string& key, const std::string& prefix) {
  const std::string word = wordIn(section, key);
  double number = 0.0;
  const char* const end = word.data() + word.size();
  const auto [after, error] = std::from_chars(word.data(), end, number);
  if (error != std::errc() || after != end) return prefix + word;
  if (!std::isfinite(number)) section.refuse(key, word + " is not finite");
  return number;
}

template <std::size_t count>
std::array<NumberSource, count> numbersIn(Section section, const char* const (&keys)[count],
                                          const std::string& prefix) {
  std::array<NumberSource, count> numbers;
  for (std::size_t i = 0; i < count; ++i) numbers[i] = numberIn(section, keys[i], prefix);
  section.finish();
  return numbers;
}

std::array<NumberSource, 3> vectorAt(const std::string& path) {
  return {path + ".x", path + ".y", path + ".z"};
}

std::array<NumberSource, 4> quaternionAt(const std::string& path) {
  return {path + ".x", path + ".y", path + ".z", path + ".w"};
}

PoseFields poseIn(Section& section, const std::string& prefix) {
  PoseFields pose;
  if (section.has("pose")) {
    const std::string path = prefix + wordIn(section, "pose");
    return {vectorAt(path + ".position"), quaternionAt(path + ".orientation")};
  }
  pose.position = numbersIn(section.section("position"), {"x", "y", "z"}, prefix);
  Section orientation = section.section("orientation");
  if (orientation.has("yaw")) {
    pose.orientation = numbersIn(orientation, {"yaw"}, prefix)[0];
  } else {
    pose.orientation = numbersIn(orientation, {"x", "y", "z", "w"}, prefix);
  }
  return pose;
}

/// Reads the fields of a topic; by default the fields of the message header.
TopicFields topicIn(Section& section) {
  TopicFields fields;
  fields.topic = wordIn(section, "topic");
  fields.type = wordIn(section, "type");
  const bool has_stamp = section.has("stamp");
  fields.stamp = has_stamp ? wordIn(section, "stamp") : "header.stamp";
  if (section.has("frame_id")) fields.frame_id = wordIn(section, "frame_id");
  if (!has_stamp || !fields.frame_id.empty()) fields.frame_id_path = "header.frame_id";
  return fields;
}

EgoMapping egoIn(Section section, const std::string& map_frame) {
  EgoMapping ego;
  ego.fields = topicIn(section);
  ego.reference = section.choice<EgoReference>(
      "reference",
      {{"base_link", EgoReference::kBaseLink}, {"box_middle", EgoReference::kBoxMiddle}});
  ego.in_transforms = kTransformTypes.count(ego.fields.type) > 0;
  ego.child_frame_id = section.has("child_frame_id") || ego.in_transforms
                           ? wordIn(section, "child_frame_id")
                           : names::kBaseFrame;
  if (!ego.in_transforms) {
    ego.pose = poseIn(section, "");
  } else if (!ego.fields.frame_id.empty() && ego.fields.frame_id != map_frame) {
    section.refuse("frame_id", ego.fields.frame_id + " is not map_frame, which is " + map_frame);
  }
  section.finish();
  return ego;
}

AgentClass classIn(Section& section, const std::string& key) {
  const std::string word = section.text(key);
  const auto found = agentClassFromString(word);
  if (!found) section.refuse(key, "'" + word + "' is not an agent class");
  return *found;
}

void readClasses(Section section, const std::string& prefix, AgentsMapping& agents) {
  agents.classification = prefix + wordIn(section, "field");
  if (section.has("probability")) agents.probability = prefix + wordIn(section, "probability");
  Section values = section.section("values");
  const std::set<std::string> words = values.unread();
  for (const std::string& word : words) agents.classes[word] = classIn(values, word);
  agents.default_class = classIn(section, "default");
  section.finish();
}

VelocityFields velocityIn(Section section, const std::string& prefix) {
  VelocityFields velocity;
  velocity.frame = section.choice<VelocityFrame>(
      "frame", {{"map", VelocityFrame::kMap}, {"object", VelocityFrame::kObject}});
  if (section.has("vector")) {
    velocity.velocity = vectorAt(prefix + wordIn(section, "vector"));
    section.finish();
  } else {
    velocity.velocity = numbersIn(section, {"x", "y", "z"}, prefix);
  }
  return velocity;
}

AgentsMapping agentsIn(Section section) {
  AgentsMapping agents;
  agents.fields = topicIn(section);
  const std::string objects = wordIn(section, "objects");
  if (objects.find('[') != std::string::npos) {
    section.refuse("objects", objects + " must be the path of the array, without brackets");
  }
  const std::string each = objects + "[].";
  agents.id = each + wordIn(section, "id");
  readClasses(section.section("class"), each, agents);
  agents.pose = poseIn(section, each);
  agents.size = numbersIn(section.section("size"), {"length", "width", "height"}, each);
  if (section.has("velocity")) agents.velocity = velocityIn(section.section("velocity"), each);
  section.finish();
  return agents;
}

}  // namespace

TopicMapping readTopicMapping(const std::string& path) {
  const std::filesystem::path file(path);
  const std::string folder = file.has_parent_path() ? file.parent_path().string() : ".";
  Section section = openConfigFile(folder, file.filename().string());
  TopicMapping mapping;
  mapping.map_frame = section.has("map_frame") ? wordIn(section, "map_frame") : names::kMapFrame;
  mapping.ego = egoIn(section.section("ego"), mapping.map_frame);
  mapping.agents = agentsIn(section.section("agents"));
  section.finish();
  return mapping;
}

}  // namespace forge
