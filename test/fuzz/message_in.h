#pragma once

#include <ros/serialization.h>

#include <cstdint>
#include <string>

#include "collision_forge/ros/bags/message_fields.h"

namespace forge {

/// Returns the message of these bytes. Throws BagError if there are too few or too many.
template <typename Message>
Message messageIn(const std::string& bytes) {
  namespace traits = ros::message_traits;
  static const MessageFields fields(traits::datatype<Message>(), traits::definition<Message>(), {});
  std::string copy = bytes;  // roscpp does not accept constant bytes
  auto* const begin = reinterpret_cast<std::uint8_t*>(copy.data());
  fields.read(begin, copy.size());
  Message message;
  ros::serialization::IStream stream(begin, static_cast<std::uint32_t>(copy.size()));
  ros::serialization::deserialize(stream, message);
  return message;
}

}  // namespace forge
