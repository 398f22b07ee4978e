#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <variant>

#include "collision_forge/base/scene/track.h"

/// Mapping from the message fields of a foreign bag to ego and agents. docs/foreign_bags.md
/// describes the keys of the file and their defaults. Paths are as in FieldPath.
namespace forge {

/// Source of a number: the path of a field (FieldPath::path), or a constant for all messages.
using NumberSource = std::variant<std::string, double>;

/// Fields of a pose.
struct PoseFields {
  std::array<NumberSource, 3> position;  ///< x, y, z, m
  /// x, y, z, w of a quaternion, or the yaw, rad.
  std::variant<std::array<NumberSource, 4>, NumberSource> orientation;
};

/// A topic and the fields common to all mapped messages.
struct TopicFields {
  std::string topic;          ///< name in the bag, with leading slash if it has one
  std::string type;           ///< required type, package/Type
  std::string stamp;          ///< path of a time field: the time of the poses
  std::string frame_id;       ///< required frame of the poses; empty: any
  std::string frame_id_path;  ///< path of the frame of the poses; empty: map_frame in all messages
};

/// Point of the ego that a pose describes: base_link or the box centre (EgoVehicle).
enum class EgoReference { kBaseLink, kBoxMiddle };

/// Fields of the ego's pose.
struct EgoMapping {
  TopicFields fields;
  PoseFields pose;                                   ///< pose of `reference`
  EgoReference reference = EgoReference::kBaseLink;  ///< point that the pose describes
  std::string child_frame_id;                        ///< tf frame of `reference`; not empty
  bool in_transforms = false;  ///< the pose is in the transforms of `fields.topic`; `pose` is empty
};

/// Frame of an agent's velocity: the frame of the poses in the message (kMap, whatever its name),
/// or the agent's box with x forward (kObject).
enum class VelocityFrame { kMap, kObject };

/// Fields of an agent's velocity.
struct VelocityFields {
  VelocityFrame frame = VelocityFrame::kMap;  ///< axes of `velocity`
  std::array<NumberSource, 3> velocity;       ///< x, y, z, m/s
};

/// Fields of the agents; paths with `[]` give one agent per element.
struct AgentsMapping {
  TopicFields fields;
  std::string id;              ///< path of an integer, a text or an array of uint8
  std::string classification;  ///< path of the class, an integer or a text
  /// Path of a number per class of an agent; the class with the greatest is used; empty: the first.
  std::string probability;
  std::map<std::string, AgentClass>
      classes;  ///< by the value of `classification` as text (decimal)
  AgentClass default_class = AgentClass::kStaticObject;  ///< for a value that `classes` lacks
  PoseFields pose;                                       ///< centre of the box
  std::array<NumberSource, 3> size;                      ///< length, width, height, m
  std::optional<VelocityFields> velocity;                ///< empty: derived from the positions
};

/// The whole mapping.
struct TopicMapping {
  /// Frame of the lanes, by default "map"; poses in other frames are transformed to it.
  std::string map_frame;
  EgoMapping ego;
  AgentsMapping agents;

  /// Returns the topic of transforms; its name with "_static" is the topic of static ones.
  std::string transformTopic() const { return ego.in_transforms ? ego.fields.topic : "/tf"; }
};

/// Reads the mapping file at `path` (YAML), with the defaults of missing optional keys. Throws
/// ConfigError with file, key and value for a missing file, and for a missing, unknown or malformed
/// key.
TopicMapping readTopicMapping(const std::string& path);

}  // namespace forge
