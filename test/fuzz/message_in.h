#pragma once

#include <ros/serialization.h>

#include <cstdint>
#include <string>

#include "collision_forge/ros/bags/message_fields.h"

namespace forge {

/// The message of these bytes. Throws BagError for bytes that are too few or too many.
template <typename Message>
Message messageIn(const std::string& bytes) {
  namespace traits = ros::message_traits;
  static const MessageFields fields(traits::datatype<Message>(), traits::definition<Message>(), {});
  std::string copy = bytes;  // roscpp takes no constant ones
  auto* const begin = reinterpret_cast<std::uint8_t*>(copy.data());
  fields.read(begin, copy.size());
  Message message;
  ros::serialization::IStream stream(begin, static_cast<std::uint32_t>(copy.size()));
  ros::serialization::deserialize(stream, message);
  return message;
}

}  // namespace forge
