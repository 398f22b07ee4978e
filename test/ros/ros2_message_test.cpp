#include "collision_forge/ros/bags/ros2_message.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ros/serialization.h>
#include <std_msgs/Header.h>
#include <visualization_msgs/Marker.h>

#include "collision_forge/ros/bags/bag_error.h"
#include "collision_forge/ros/messages/ros_bytes.h"

namespace forge {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Numbers written as in both formats, little-endian.
template <typename... Numbers>
std::string bytesOf(Numbers... numbers) {
  std::string bytes;
  (bytes.append(reinterpret_cast<const char*>(&numbers), sizeof numbers), ...);
  return bytes;
}

const std::string kStart("\0\1\0\0", 4);  // CDR_LE

std::string zeros(std::size_t count) { return std::string(count, '\0'); }

template <typename Message>
std::string serialised(const Message& message) {
  std::string bytes;
  appendRosBytes(bytes, message);
  return bytes;
}

template <typename Message>
Ros2Message typeOf() {
  return {ros::message_traits::datatype<Message>(), ros::message_traits::definition<Message>()};
}

TEST(Ros2Message, NumbersAreAlignedToTheirSize) {
  const Ros2Message type("pkg/Numbers", "uint8 a\nfloat64 b\nint16 c\nint32 d\nbool e\nint64 f\n");
  const std::string old =
      bytesOf(std::uint8_t{1}, 2.0, std::int16_t{3}, std::int32_t{4}, true, std::int64_t{5});
  EXPECT_EQ(type.type(), "pkg/msg/Numbers");
  EXPECT_EQ(type.cdrOf(old), kStart + bytesOf(std::uint8_t{1}) + zeros(7) + bytesOf(2.0) +
                                 bytesOf(std::int16_t{3}) + zeros(2) + bytesOf(std::int32_t{4}) +
                                 bytesOf(true) + zeros(7) + bytesOf(std::int64_t{5}));
}

TEST(Ros2Message, TextsAndArraysHaveAlignedLengths) {
  const Ros2Message type("pkg/Arrays",
                         "string[] names\nuint8[] data\nfloat64[] none\nint16[2] pair\n");
  const std::string old = bytesOf(2U, 1U) + "a" + bytesOf(2U) + "bc" + bytesOf(3U) + "xyz" +
                          bytesOf(0U) + bytesOf(std::int16_t{7}, std::int16_t{8});
  const std::string expected = kStart + bytesOf(2U, 2U) + "a" + zeros(3) + bytesOf(3U) + "bc" +
                               zeros(2) + bytesOf(3U) + "xyz" + zeros(1) + bytesOf(0U) +
                               bytesOf(std::int16_t{7}, std::int16_t{8});
  EXPECT_EQ(type.cdrOf(old), expected);
}

TEST(Ros2Message, HeadersLoseTheirNumberAndTimesBecomeMessages) {
  std_msgs::Header header;
  header.seq = 9;
  header.stamp = ros::Time(5, 6);
  header.frame_id = "map";
  const Ros2Message type = typeOf<std_msgs::Header>();
  EXPECT_EQ(type.cdrOf(serialised(header)), kStart + bytesOf(5U, 6U, 4U) + std::string("map\0", 4));
  EXPECT_THAT(type.definition(), Not(HasSubstr("uint32 seq")));
  EXPECT_THAT(type.definition(), HasSubstr("builtin_interfaces/Time stamp\n"));
  EXPECT_THAT(type.definition(),
              HasSubstr("MSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec"));
}

TEST(Ros2Message, MarkersGetTheFieldsOfRos2) {
  visualization_msgs::Marker marker;
  marker.colors.resize(1);
  marker.text = "t";
  marker.mesh_resource = "m";
  marker.mesh_use_embedded_materials = 1;
  const std::string cdr = typeOf<visualization_msgs::Marker>().cdrOf(serialised(marker));
  // Texture: a name, a header, a format, bytes and coordinates, all empty.
  const std::string texture = bytesOf(1U) + zeros(4) + bytesOf(0U, 0U) + bytesOf(1U) + zeros(4) +
                              bytesOf(1U) + zeros(4) + bytesOf(0U) + bytesOf(0U);
  const std::string text = bytesOf(2U) + std::string("t\0\0\0", 4);
  const std::string mesh =
      bytesOf(2U) + std::string("m\0\0\0", 4) + bytesOf(1U) + zeros(4) + bytesOf(0U);
  EXPECT_THAT(cdr, testing::EndsWith(zeros(16) + texture + text + mesh + "\1"));
}

TEST(Ros2Message, TypesAndFieldsAreRenamed) {
  const Ros2Message own("collision_forge/A", "B b\nfloat64[9] K\nstring WORD=it's \"x\" # 1\n" +
                                                 std::string(80, '=') +
                                                 "\nMSG: collision_forge/B\nuint8 ONE=1  # one\n");
  EXPECT_EQ(own.type(), "collision_forge_msgs/msg/A");
  EXPECT_EQ(own.definition(), "B b\nfloat64[9] k\nstring WORD=\"it's \\\"x\\\" # 1\"\n" +
                                  std::string(80, '=') +
                                  "\nMSG: collision_forge_msgs/B\nuint8 ONE=1  # one\n");
  EXPECT_EQ(own.cdrOf(zeros(72)), kStart + zeros(1) + zeros(7) + zeros(72)) << "B has no field";
  EXPECT_EQ(Ros2Message("tf/tfMessage", "").type(), "tf2_msgs/msg/TFMessage");
  const auto types = ownRos2Types(own.type(), own.definition());
  ASSERT_EQ(types.size(), 2U);
  EXPECT_EQ(types.at("B"), "uint8 ONE=1  # one\n");
}

TEST(Ros2Message, WrongSizesAreRejected) {
  const Ros2Message type("pkg/Texts", "string[] texts\n");
  EXPECT_THROW(type.cdrOf(bytesOf(1000000U)), ros::serialization::StreamOverrunException);
  EXPECT_THROW(type.cdrOf(bytesOf(1U, 9U) + "short"), ros::serialization::StreamOverrunException);
  EXPECT_THROW(type.cdrOf(bytesOf(0U) + "x"), BagError);
  const Ros2Message empty("pkg/Many", "Empty[] all\n====\nMSG: pkg/Empty\n");
  EXPECT_THROW(empty.cdrOf(bytesOf(4000000000U)), ros::serialization::StreamOverrunException);
  EXPECT_THROW(Ros2Message("pkg/Unknown", "Other other\n"), BagError);
}

}  // namespace
}  // namespace forge
