#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <variant>

#include "collision_forge/base/scene/track.h"

/// Topics and fields of ego and agents in a bag of another source: a file like
/// config/topics_autoware.yaml, which explains every key.
namespace forge {

/// Source of a number: a FieldPath, or a constant for all messages.
using NumberSource = std::variant<std::string, double>;

struct PoseFields {
  std::array<NumberSource, 3> position;  ///< x, y, z, m
  /// x, y, z, w of a quaternion, or the yaw, rad.
  std::variant<std::array<NumberSource, 4>, NumberSource> orientation;
};

/// A topic and the fields that all its messages have.
struct TopicFields {
  std::string topic;
  std::string type;           ///< with its package
  std::string stamp;          ///< path of a time
  std::string frame_id;       ///< required frame of poses; empty: any
  std::string frame_id_path;  ///< path of the frame's name in a message
};

enum class EgoReference { kBaseLink, kBoxMiddle };

struct EgoMapping {
  TopicFields fields;
  PoseFields pose;
  EgoReference reference = EgoReference::kBaseLink;  ///< what the pose is of
  /// Of a tf2_msgs/TFMessage: the frame whose pose it is, and where a transform names it.
  /// Transforms of other frames are none of the ego. Empty for other types.
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
  std::string id;              ///< of a number, a text or an array of uint8
  std::string classification;  ///< path of the class: of an integer or a text
  std::string probability;     ///< of several classes the likeliest counts; empty: the first
  std::map<std::string, AgentClass> classes;  ///< by what stands there
  AgentClass default_class = AgentClass::kStaticObject;
  PoseFields pose;                         ///< of the middle of the box
  std::array<NumberSource, 3> size;        ///< length, width, height, m
  std::optional<VelocityFields> velocity;  ///< none: derived from the positions
};

struct TopicMapping {
  EgoMapping ego;
  AgentsMapping agents;
};

/// Throws ConfigError naming file, key and value.
TopicMapping readTopicMapping(const std::string& path);

}  // namespace forge
