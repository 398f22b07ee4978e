#include "collision_forge/ros/bags/mcap_messages.h"

#include <ros/serialization.h>

#include <algorithm>
#include <utility>

#include "collision_forge/ros/bags/bag_error.h"

namespace forge {
namespace {

constexpr char kLibrary[] = "collision_forge";

/// Returns a profile as rosbag2 of Humble writes it: numbers as in rmw/types.h, times without
/// limit.
std::string qosOf(bool is_latched) {
  const std::string no_limit = "\n    sec: 9223372036\n    nsec: 854775807";
  return "- history: 1\n  depth: " + std::string(is_latched ? "1" : "10") +
         "\n  reliability: 1\n  durability: " + (is_latched ? "1" : "2") +
         "\n  deadline:" + no_limit + "\n  lifespan:" + no_limit +
         "\n  liveliness: 1\n  liveliness_lease_duration:" + no_limit +
         "\n  avoid_ros_namespace_conventions: false";
}

}  // namespace

McapMessages::McapMessages(std::ostream& stream, McapProfile profile)
    : writer_(stream, profile == McapProfile::kRos2 ? "ros2" : "ros1", kLibrary),
      profile_(profile) {}

std::size_t McapMessages::addTopic(const std::string& topic, const std::string& type,
                                   const std::string& definition,
                                   std::map<std::string, std::string> header) {
  Entry entry;
  entry.topic = {topic, type, definition, "", 0};
  McapChannel channel{0, topic, kRos1Encoding, std::move(header)};
  if (profile_ == McapProfile::kRos2) {
    entry.topic.qos = qosOf(channel.metadata["latching"] == "1");
    channel.message_encoding = kRos2Encoding;
    channel.metadata = {{"offered_qos_profiles", entry.topic.qos}};
    try {
      entry.converter = std::make_unique<const Ros2Message>(type, definition);
      entry.topic.type = entry.converter->type();
      entry.topic.definition = entry.converter->definition();
    } catch (const BagError& error) {
      entry.failure = error.what();
    }
  }
  const auto known = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& other) {
    return profile_ == McapProfile::kRos2 && other.topic.name == topic &&
           other.topic.definition == entry.topic.definition && other.topic.qos == entry.topic.qos;
  });
  if (known != entries_.end()) return static_cast<std::size_t>(known - entries_.begin());
  if (entry.failure.empty()) {
    channel.schema =
        writer_.addSchema({entry.topic.type, entry.converter ? kRos2Definition : kRos1Definition,
                           entry.topic.definition});
    entry.channel = writer_.addChannel(std::move(channel));
  }
  entries_.push_back(std::move(entry));
  return entries_.size() - 1;
}

void McapMessages::write(std::size_t topic, const ros::Time& time, std::string_view message) {
  Entry& entry = entries_[topic];
  const bool is_convertible = entry.converter || profile_ == McapProfile::kRos1;
  try {
    if (is_convertible) {
      const std::string cdr = entry.converter ? entry.converter->cdrOf(message) : std::string();
      writer_.write(entry.channel, time.toNSec(), entry.converter ? cdr : message);
      ++entry.topic.written;
      return;
    }
  } catch (const BagError& error) {
    if (entry.failure.empty()) entry.failure = error.what();
  } catch (const ros::serialization::StreamOverrunException&) {
    if (entry.failure.empty()) entry.failure = "a message is shorter than its type";
  }
  ++entry.left_out;
}

std::vector<McapMessages::Topic> McapMessages::topics() const {
  std::vector<Topic> topics;
  for (const Entry& entry : entries_) {
    if (entry.converter || profile_ == McapProfile::kRos1) topics.push_back(entry.topic);
  }
  return topics;
}

std::vector<std::string> McapMessages::warnings() const {
  std::vector<std::string> lines;
  for (const Entry& entry : entries_) {
    if (entry.failure.empty()) continue;
    lines.push_back(std::to_string(entry.left_out) + " messages of " + entry.topic.name +
                    " left out: " + entry.failure);
  }
  return lines;
}

}  // namespace forge
