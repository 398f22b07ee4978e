#pragma once

#include <ros/time.h>

#include <cstdint>
#include <iosfwd>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "collision_forge/ros/bags/mcap_writer.h"
#include "collision_forge/ros/bags/ros2_message.h"

namespace forge {

/// Profile of an MCAP file: the ROS version whose tools read it.
enum class McapProfile { kRos1, kRos2 };

/// Writes ROS 1 messages to an MCAP file: unchanged in profile ros1, converted by Ros2Message in
/// profile ros2. Topics and messages that cannot be converted are left out and counted.
class McapMessages {
 public:
  /// A topic in the file.
  struct Topic {
    std::string name;
    std::string type;           ///< package/msg/Type in profile ros2, else package/Type
    std::string definition;     ///< ros2msg in profile ros2, else ros1msg
    std::string qos;            ///< offered_qos_profiles of rosbag2; "" in profile ros1
    std::uint64_t written = 0;  ///< messages
  };

  /// `stream` must be binary, at the beginning of a file, and outlive the object.
  McapMessages(std::ostream& stream, McapProfile profile);

  /// Adds a topic of ROS 1 and returns its number, from 0; in profile ros2 the number of an equal
  /// topic if there is one, as of several publishers. `header`: fields of the connection, with
  /// `latching` "1" for a latched topic, which becomes transient local in ROS 2. Throws
  /// std::length_error after 65,535 topics.
  std::size_t addTopic(const std::string& topic, const std::string& type,
                       const std::string& definition, std::map<std::string, std::string> header);

  /// Writes a serialised ROS 1 message; `time`: in the bag.
  void write(std::size_t topic, const ros::Time& time, std::string_view message);

  /// Ends the file. Must be called once, as the last call.
  void finish() { writer_.finish(); }

  /// Returns the topics in the file.
  std::vector<Topic> topics() const;
  /// Returns one line per topic that was left out, wholly or in part.
  std::vector<std::string> warnings() const;

 private:
  struct Entry {
    Topic topic;
    std::uint16_t channel = 0;
    std::unique_ptr<const Ros2Message> converter;  ///< null in profile ros1
    std::string failure;                           ///< of the first message, or of the definition
    std::uint64_t left_out = 0;                    ///< messages
  };

  McapWriter writer_;
  McapProfile profile_;
  std::vector<Entry> entries_;
};

}  // namespace forge
