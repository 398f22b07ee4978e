#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <variant>

#include "collision_forge/base/scene/track.h"

/// Mapping from the message fields of a foreign bag to ego and agents. Each key is described in
/// config/topics_autoware.yaml.
namespace forge {

/// Source of a number: the path of a field (FieldPath), or a constant for all messages.
using NumberSource = std::variant<std::string, double>;

struct PoseFields {
  std::array<NumberSource, 3> position;  ///< x, y, z, m
  /// x, y, z, w of a quaternion, or the yaw, rad.
  std::variant<std::array<NumberSource, 4>, NumberSource> orientation;
};

/// A topic and the fields common to all mapped messages.
struct TopicFields {
  std::string topic;
  std::string type;           ///< package/Type
  std::string stamp;          ///< path of a time field
  std::string frame_id;       ///< required frame of poses; empty: not checked
  std::string frame_id_path;  ///< path of the field with the frame of the poses
};

enum class EgoReference { kBaseLink, kBoxMiddle };

struct EgoMapping {
  TopicFields fields;
  PoseFields pose;
  EgoReference reference = EgoReference::kBaseLink;  ///< point that the pose describes
  /// For tf2_msgs/TFMessage: the ego's frame, and the path of the child frame in a transform.
  /// Transforms of other frames are ignored. Empty for other types.
  std::string child_frame_id;
  std::string child_frame_id_path;
};

enum class VelocityFrame { kMap, kObject };

struct VelocityFields {
  VelocityFrame frame = VelocityFrame::kMap;
  std::array<NumberSource, 3> velocity;  ///< x, y, z, m/s
};

struct AgentsMapping {
  TopicFields fields;
  std::string id;              ///< path of a number, a text or an array of uint8
  std::string classification;  ///< path of the class, an integer or a text
  std::string probability;     ///< path; selects the most probable class; empty: the first
  std::map<std::string, AgentClass> classes;  ///< by the value of `classification`
  AgentClass default_class = AgentClass::kStaticObject;
  PoseFields pose;                         ///< middle of the box
  std::array<NumberSource, 3> size;        ///< length, width, height, m
  std::optional<VelocityFields> velocity;  ///< empty: derived from the positions
};

struct TopicMapping {
  EgoMapping ego;
  AgentsMapping agents;
};

/// Reads a mapping file. Throws ConfigError with file, key and value.
TopicMapping readTopicMapping(const std::string& path);

}  // namespace forge
