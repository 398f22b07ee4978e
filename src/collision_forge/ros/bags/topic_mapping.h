#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <variant>

#include "collision_forge/base/scene/track.h"

/// Where a bag of others has the ego and the agents: a file like config/topics_autoware.yaml, in
/// which every key is told.
namespace forge {

/// Where a number is: a path as FieldPath has it, or a number that stands for all messages.
using NumberSource = std::variant<std::string, double>;

struct PoseFields {
  std::array<NumberSource, 3> position;  ///< x, y, z, m
  /// x, y, z, w of a quaternion, or the yaw, rad.
  std::variant<std::array<NumberSource, 4>, NumberSource> orientation;
};

/// A topic and what belongs to every message of it.
struct TopicFields {
  std::string topic;
  std::string type;           ///< with its package
  std::string stamp;          ///< path of a time
  std::string frame_id;       ///< the frame that poses are to be in; empty: nobody asks
  std::string frame_id_path;  ///< where a message says which they are in
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
