#pragma once

#include <ros/message_traits.h>
#include <ros/serialization.h>
#include <rosbag/message_instance.h>

#include <boost/make_shared.hpp>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "collision_forge/ros/bags/message_definition.h"

namespace forge {

/// Converts the serialised message `bytes` of type `from` to another version `to` of the type and
/// returns its bytes. Fields of one name, type and shape are copied (nested types field by field),
/// other fields of `to` are 0 or empty, other fields of `from` and bytes after its last field are
/// dropped. Throws BagError, without a path, if `bytes` ends within a field.
std::vector<std::uint8_t> convertMessage(const MessageType& from, const MessageType& to,
                                         const std::vector<std::uint8_t>& bytes);

/// Returns the message of a bag if its type is `Message`, in the current version or in another one,
/// which is converted (convertMessage()) by its definition in the bag; null for other types. Throws
/// BagError for a message of another version that cannot be read, and
/// ros::serialization::StreamOverrunException for one of the current version.
template <typename Message>
boost::shared_ptr<Message> readMessage(const rosbag::MessageInstance& instance) {
  if (auto current = instance.instantiate<Message>()) return current;
  const std::string type = ros::message_traits::datatype<Message>();
  if (instance.getDataType() != type) return nullptr;
  std::vector<std::uint8_t> bytes(instance.size());
  ros::serialization::OStream written(bytes.data(), instance.size());
  instance.write(written);
  const MessageDefinition from(type, instance.getMessageDefinition());
  const MessageDefinition to(type, ros::message_traits::definition<Message>());
  std::vector<std::uint8_t> converted = convertMessage(from.message(), to.message(), bytes);
  ros::serialization::IStream stream(converted.data(),
                                     static_cast<std::uint32_t>(converted.size()));
  auto message = boost::make_shared<Message>();
  ros::serialization::deserialize(stream, *message);
  return message;
}

}  // namespace forge
