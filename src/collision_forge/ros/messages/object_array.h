#pragma once

#include <collision_forge/AgentArray.h>
#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Vector3.h>
#include <ros/message_traits.h>
#include <ros/serialization.h>
#include <std_msgs/Header.h>

#include <cstdint>
#include <string>
#include <vector>

/// The part of derived_object_msgs/ObjectArray that this package writes for other tools. Debian
/// does not package this message, so its definition is included here.
namespace forge {

extern const char kObjectArrayDefinition[];  ///< text of the message definition with nested types

/// derived_object_msgs/Object: a tracked box. Polygon and acceleration are empty and the age of the
/// class is 0, because they are unknown.
struct DerivedObject {
  std::uint32_t id = 0;             ///< objectId() of the agent
  geometry_msgs::Pose pose;         ///< middle of the box, frame of the header
  geometry_msgs::Vector3 velocity;  ///< m/s, frame of the header
  geometry_msgs::Vector3 size;      ///< m: x length, y width, z height
  std::uint8_t classification = 0;  ///< constant of derived_object_msgs/Object, 0: unknown
};

/// derived_object_msgs/ObjectArray: the tracked boxes at one time.
struct ObjectArray {
  std_msgs::Header header;  ///< also written as header of each object
  std::vector<DerivedObject> objects;
};

/// Returns the id as a number if it is a decimal of 32 bits, else the CRC-32 of the id: equal in
/// all frames, but two agents may get one number.
std::uint32_t objectId(const std::string& agent_id);

/// Converts a frame of agents; header and order are kept. A class that derived_object_msgs lacks
/// becomes "other vehicle" (bus, trailer, construction and emergency vehicle) or "unknown" (animal,
/// static object, unknown constant). Nothing is checked.
ObjectArray toObjects(const collision_forge::AgentArray& agents);

}  // namespace forge

namespace ros {
namespace message_traits {

template <>
struct DataType<forge::ObjectArray> {
  static const char* value() { return "derived_object_msgs/ObjectArray"; }
  static const char* value(const forge::ObjectArray& /*message*/) { return value(); }
};

template <>
struct MD5Sum<forge::ObjectArray> {
  static const char* value() { return "492c83cd255b9a57845d0c197d7977be"; }
  static const char* value(const forge::ObjectArray& /*message*/) { return value(); }
};

template <>
struct Definition<forge::ObjectArray> {
  static const char* value() { return forge::kObjectArrayDefinition; }
  static const char* value(const forge::ObjectArray& /*message*/) { return value(); }
};

}  // namespace message_traits

namespace serialization {

template <>
struct Serializer<forge::ObjectArray> {
  template <typename Stream>
  static void write(Stream& stream, const forge::ObjectArray& message) {
    stream.next(message.header);
    stream.next(static_cast<std::uint32_t>(message.objects.size()));
    for (const forge::DerivedObject& object : message.objects) {
      stream.next(message.header);
      writeObject(stream, object);
    }
  }

  static std::uint32_t serializedLength(const forge::ObjectArray& message) {
    LStream stream;
    write(stream, message);
    return stream.getLength();
  }

 private:
  template <typename Stream>
  static void writeObject(Stream& stream, const forge::DerivedObject& object) {
    constexpr std::uint8_t kTracked = 1;
    constexpr std::uint8_t kBox = 1;
    constexpr std::uint8_t kCertain = 255;
    const geometry_msgs::Vector3 none;
    const std::uint8_t is_classified = object.classification != 0 ? 1 : 0;
    stream.next(object.id);
    stream.next(kTracked);
    stream.next(is_classified);
    stream.next(object.pose);
    for (const auto& vector : {object.velocity, none, none, none}) {  // twist and acceleration
      stream.next(vector);
    }
    stream.next(std::uint32_t{0});  // points of the polygon
    stream.next(kBox);
    stream.next(std::vector<double>{object.size.x, object.size.y, object.size.z});
    stream.next(object.classification);
    stream.next(static_cast<std::uint8_t>(is_classified * kCertain));
    stream.next(std::uint32_t{0});  // age of the class
  }
};

}  // namespace serialization
}  // namespace ros
