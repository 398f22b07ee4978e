#pragma once

#include <ros/serialization.h>

#include <cstdint>
#include <string>

namespace forge {

/// Appends a message, or one of its fields, to `bytes` as ROS 1 serialises it.
template <typename Field>
void appendRosBytes(std::string& bytes, const Field& field) {
  const std::size_t begin = bytes.size();
  const std::uint32_t length = ros::serialization::serializationLength(field);
  bytes.resize(begin + length);
  auto* const place = reinterpret_cast<std::uint8_t*>(bytes.data() + begin);
  ros::serialization::OStream stream(place, length);
  ros::serialization::serialize(stream, field);
}

}  // namespace forge
