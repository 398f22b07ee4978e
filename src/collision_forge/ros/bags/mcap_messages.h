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

/// Profile of an MCAP file: the ROS version whose tools read it; "ros1" or "ros2" in the file.
enum class McapProfile { kRos1, kRos2 };

/// Writes ROS 1 messages to an MCAP file: unchanged in profile ros1, converted by Ros2Message in
/// profile ros2. Topics and messages that cannot be converted are left out and counted. Not
/// thread-safe.
class McapMessages {
 public:
  /// A topic in the file.
  struct Topic {
    std::string name;           ///< with leading slash, as in the bag
    std::string type;           ///< package/msg/Type in profile ros2, else package/Type
    std::string definition;     ///< ros2msg in profile ros2, else ros1msg
    std::string qos;            ///< offered_qos_profiles of rosbag2; "" in profile ros1
    std::uint64_t written = 0;  ///< number of written messages
  };

  /// `stream` must be binary, at the beginning of a file, and outlive the object. The caller checks
  /// it for write errors after finish().
  McapMessages(std::ostream& stream, McapProfile profile);

  /// Adds a topic of ROS 1 and returns its number, from 0; in profile ros2 the number of an equal
  /// topic (name, definition and latching) if there is one, as of several publishers. `type`:
  /// package/Type; `definition`: its ROS 1 text with nested types. `header`: fields of the
  /// connection, with `latching` "1" for a latched topic, which becomes transient local in ROS 2. A
  /// definition that cannot be converted is no error: the topic still gets a number, and its
  /// messages are left out. Throws std::length_error after 65,535 topics.
  std::size_t addTopic(const std::string& topic, const std::string& type,
                       const std::string& definition, std::map<std::string, std::string> header);

  /// Writes a serialised ROS 1 message to the topic with the number `topic` (addTopic()); `time`:
  /// its record time in the bag. A message that cannot be converted is left out and counted.
  void write(std::size_t topic, const ros::Time& time, std::string_view message);

  /// Ends the file. Must be called once, as the last call.
  void finish() { writer_.finish(); }

  /// Returns the topics in the file, in the order of addTopic(), without those whose definition
  /// cannot be converted.
  std::vector<Topic> topics() const;
  /// Returns one line per topic that was left out, wholly or in part, in the order of addTopic(),
  /// with the number of messages left out and the first reason; none if nothing was left out.
  std::vector<std::string> warnings() const;

 private:
  /// A topic of addTopic(), also one that is not in the file.
  struct Entry {
    Topic topic;
    std::uint16_t channel = 0;                     ///< number in the file
    std::unique_ptr<const Ros2Message> converter;  ///< null in profile ros1
    std::string failure;         ///< first error of the definition or of a message; empty: none
    std::uint64_t left_out = 0;  ///< number of messages left out
  };

  McapWriter writer_;
  McapProfile profile_;
  std::vector<Entry> entries_;  ///< index: number that addTopic() returned
};

}  // namespace forge
