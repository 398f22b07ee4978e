#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "collision_forge/ros/bags/message_definition.h"

namespace forge {

/// Package of this package's message types in ROS 2.
inline constexpr char kRos2Package[] = "collision_forge_msgs";

/// Converts the messages of one ROS 1 type to ROS 2 (Humble and later): the definition to the
/// format ros2msg (mcap.dev/spec/registry), the bytes to CDR, little-endian (OMG DDS-XTypes 1.3,
/// 7.4.1, encoding version 1). Types of package collision_forge become types of kRos2Package,
/// tf/tfMessage becomes tf2_msgs/TFMessage; all others keep their names. std_msgs/Header loses
/// `seq`, visualization_msgs/Marker gets the fields that ROS 2 adds, with default values; names of
/// fields become lower case. Constant after construction, so thread-safe.
class Ros2Message {
 public:
  /// `type`: package/Type in ROS 1. `definition`: text in the bag's connection, with nested types.
  /// Throws BagError like MessageDefinition.
  Ros2Message(const std::string& type, const std::string& definition);

  /// Returns the ROS 2 type, as package/msg/Type.
  const std::string& type() const { return type_; }
  /// Returns the definition of the type and its nested types, as ros2msg.
  const std::string& definition() const { return text_; }

  /// Returns a serialised ROS 1 message as CDR, from the encapsulation header of 4 bytes on, as
  /// MCAP files store it. Throws ros::serialization::StreamOverrunException if `bytes` ends within
  /// a field, and BagError if it continues after the last one.
  std::string cdrOf(std::string_view bytes) const;

 private:
  struct Move;
  using Plan = std::vector<Move>;
  /// A field of the ROS 1 type, of the ROS 2 type, or both: dropped, added or converted.
  struct Move {
    const MessageField* from = nullptr;  ///< null: added in ROS 2
    const MessageField* to = nullptr;    ///< null: dropped in ROS 2
    const Plan* nested = nullptr;        ///< for fields of a message type
  };
  class Conversion;

  /// Returns the conversion of a type, which `plans_` keeps.
  const Plan& planOf(const MessageType& from, const MessageType& to);

  std::string type_;                             ///< package/msg/Type
  std::string text_;                             ///< definition as ros2msg
  MessageDefinition from_;                       ///< of ROS 1
  std::unique_ptr<const MessageDefinition> to_;  ///< of ROS 2
  std::map<std::pair<const MessageType*, const MessageType*>, Plan> plans_;  ///< by both types
  const Plan* plan_ = nullptr;  ///< of the whole message, in `plans_`
};

/// Returns the types of kRos2Package in `definition` (Ros2Message::definition()): the text of each
/// type's fields, as in a .msg file, by its name without package; empty if there are none. `type`:
/// package/msg/Type, the type at the beginning of the text.
std::map<std::string, std::string> ownRos2Types(const std::string& type,
                                                const std::string& definition);

}  // namespace forge
