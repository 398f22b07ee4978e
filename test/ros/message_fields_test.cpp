#include "collision_forge/ros/bags/message_fields.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <std_msgs/Header.h>

#include "collision_forge/ros/bags/bag_file.h"
#include "collision_forge/ros/messages/object_array.h"
#include "collision_forge/ros/messages/ros_bytes.h"

namespace forge {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr char kType[] = "zoo_msgs/Cage";

std::vector<FieldRows> read(const std::string& definition, const std::vector<FieldPath>& paths,
                            const std::string& bytes) {
  return MessageFields(kType, definition, paths)
      .read(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

std::string complaintOf(const std::string& definition, const std::vector<FieldPath>& paths,
                        const std::string& bytes = "") {
  try {
    read(definition, paths, bytes);
  } catch (const BagError& error) {
    EXPECT_THAT(error.what(), HasSubstr("zoo_msgs/"));
    return error.what();
  }
  return "";
}

/// The bytes of these fields, one after the other.
template <typename... Field>
std::string bytesOf(const Field&... fields) {
  std::string bytes;
  (appendRosBytes(bytes, fields), ...);
  return bytes;
}

std::vector<FieldValue> row(FieldValue value) { return {std::move(value)}; }

constexpr char kRule[] =
    "================================================================================\n";

TEST(MessageFields, EveryBuiltinTypeIsRead) {
  const std::string definition =
      "bool a\nint8 b\nuint8 c\nint16 d\nuint16 e\nint32 f\nuint32 g\nint64 h\nuint64 i\n"
      "float32 j\nfloat64 k\nbyte l\nchar m\nduration n\ntime o\nstring p\n";
  const std::string bytes =
      bytesOf(std::uint8_t{1}, std::int8_t{-2}, std::uint8_t{250}, std::int16_t{-300},
              std::uint16_t{65000}, std::int32_t{-70000}, std::uint32_t{4000000000},
              std::int64_t{-5}, ~std::uint64_t{0}, 0.5F, -2.25, std::int8_t{-1}, std::uint8_t{255},
              ros::Duration(1, 2), ros::Time(1700000000, 7), std::string("lion"));
  const std::pair<std::string, double> numbers[] = {
      {"a", 1.0},     {"b", -2.0},     {"c", 250.0},        {"d", -300.0},
      {"e", 65000.0}, {"f", -70000.0}, {"g", 4000000000.0}, {"h", -5.0},
      {"j", 0.5},     {"k", -2.25},    {"l", -1.0},         {"m", 255.0}};
  for (const auto& [name, value] : numbers) {
    EXPECT_THAT(read(definition, {{name, FieldKind::kNumber}}, bytes).front(),
                ElementsAre(row(value)))
        << name;
  }
  const std::pair<std::string, std::string> texts[] = {
      {"b", "-2"}, {"c", "250"}, {"i", "18446744073709551615"}, {"p", "lion"}};
  for (const auto& [name, value] : texts) {
    EXPECT_THAT(read(definition, {{name, FieldKind::kText}}, bytes).front(),
                ElementsAre(row(value)))
        << name;
  }
  EXPECT_THAT(read(definition, {{"o", FieldKind::kTime}}, bytes).front(),
              ElementsAre(row(std::int64_t{1700000000000000007})));
}

const std::string kCage =
    std::string("Header header\nAnimal[] animals\nother_msgs/Door door\n") + kRule +
    "MSG: std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id\n" + kRule +
    "MSG: zoo_msgs/Animal\nstring name\nfloat32[2] size\n" + "uint8[3] tag\nLimb[] limbs\n" +
    kRule + "MSG: zoo_msgs/Limb\nfloat64 length\n" + kRule +
    "MSG: other_msgs/Door\nLimb[] parts\n" + kRule + "MSG: other_msgs/Limb\nint16 length\n";

std_msgs::Header header() {
  std_msgs::Header header;
  header.stamp = ros::Time(3, 4);
  header.frame_id = "map";
  return header;
}

/// Two animals, with one limb and with two.
std::string cageBytes() {
  using Bytes = boost::array<std::uint8_t, 3>;
  using Sizes = boost::array<float, 2>;
  return bytesOf(header(), std::uint32_t{2},                                       //
                 std::string("cat"), Sizes{{0.5F, 0.25F}}, Bytes{{1, 0xab, 255}},  //
                 std::vector<double>{7.0},                                         //
                 std::string("dog"), Sizes{{1.5F, 1.25F}}, Bytes{{0, 0, 16}},      //
                 std::vector<double>{8.0, 9.0}, std::vector<std::int16_t>{-3});
}

TEST(MessageFields, PathsLeadThroughMessagesAndArrays) {
  const auto values = read(kCage,
                           {{"header.stamp", FieldKind::kTime},
                            {"header.frame_id", FieldKind::kText},
                            {"animals[].name", FieldKind::kText},
                            {"animals[].size[1]"},
                            {"animals[].tag", FieldKind::kText},
                            {"animals[].tag[1]"},
                            {"animals[].limbs[1].length"},
                            {"animals[].limbs[].length"},
                            {"animals[1].size[]"},
                            {"animals[1].name", FieldKind::kText},
                            {"door.parts[0].length"},
                            {"animals[].name", FieldKind::kText}},
                           cageBytes());
  ASSERT_EQ(values.size(), 12U);
  const std::string cat = "cat";
  const std::string dog = "dog";
  EXPECT_THAT(values[0], ElementsAre(row(std::int64_t{3000000004})));
  EXPECT_THAT(values[1], ElementsAre(row(std::string("map"))));
  EXPECT_THAT(values[2], ElementsAre(row(cat), row(dog)));
  EXPECT_THAT(values[3], ElementsAre(row(0.25), row(1.25)));
  EXPECT_THAT(values[4], ElementsAre(row(std::string("01abff")), row(std::string("000010"))));
  EXPECT_THAT(values[5], ElementsAre(row(171.0), row(0.0)));
  EXPECT_THAT(values[6], ElementsAre(IsEmpty(), row(9.0))) << "the cat has one limb";
  EXPECT_THAT(values[7], ElementsAre(row(7.0), std::vector<FieldValue>{8.0, 9.0}));
  EXPECT_THAT(values[8], ElementsAre(row(1.5), row(1.25)));
  EXPECT_THAT(values[9], ElementsAre(row(dog)));
  EXPECT_THAT(values[10], ElementsAre(row(-3.0))) << "Limb is that of its own package";
  EXPECT_EQ(values[11], values[2]);
}

/// 5^25 bytes: they cannot be there, and nobody looks for them.
TEST(MessageFields, HugeNestedTypesAreParsedQuickly) {
  std::string definition = "T0 x\n";
  for (int i = 0; i < 25; ++i) {
    const std::string next = "T" + std::to_string(i + 1);
    definition +=
        kRule + ("MSG: zoo_msgs/T" + std::to_string(i)) + "\n" + next + "[4] a\n" + next + " b\n";
  }
  definition += std::string(kRule) + "MSG: zoo_msgs/T25\nuint8 a\n";
  EXPECT_THAT(complaintOf(definition, {}, "abc"), HasSubstr("end within its fields"));
}

TEST(MessageFields, RecursiveTypesAreRejected) {
  EXPECT_THAT(
      complaintOf(std::string("Box box\n") + kRule + "MSG: zoo_msgs/Box\nBox[] inner\n", {}),
      testing::AllOf(HasSubstr("zoo_msgs/Box"), HasSubstr("inner"),
                     HasSubstr("does a type contain itself?")));
  EXPECT_THAT(complaintOf("Cage cage\n", {}), HasSubstr("does a type contain itself?"));
}

TEST(MessageFields, UnreadableDefinitionsAreRejected) {
  EXPECT_THAT(complaintOf("Lion lion\n", {}), HasSubstr("type Lion of its field lion"));
  EXPECT_THAT(complaintOf("float64\n", {}), HasSubstr("'float64'"));
  EXPECT_THAT(complaintOf("uint8 a b\n", {}), HasSubstr("'uint8 a b'"));
  EXPECT_THAT(complaintOf(std::string("uint8 a\0b\n", 10), {}), HasSubstr("has a zero byte"));
  EXPECT_THAT(complaintOf("uint8[x] a\n", {}), HasSubstr("'uint8[x] a'"));
  EXPECT_THAT(complaintOf("uint8[-1] a\n", {}), HasSubstr("'uint8[-1] a'"));
  EXPECT_THAT(complaintOf("uint8[3 a\n", {}), HasSubstr("'uint8[3 a'"));
  EXPECT_THAT(complaintOf("uint8[99999999999999999999] a\n", {}), HasSubstr("[9999"));
  EXPECT_THAT(complaintOf("", {{"header.stamp", FieldKind::kTime}}),
              HasSubstr("has no field 'header'; its fields are none"));
}

TEST(MessageFields, PathsWithoutAFieldAreRejected) {
  struct Case {
    const char* path;
    FieldKind kind;
    const char* complaint;
  };
  const Case cases[] = {
      {"", FieldKind::kNumber, "no field ''"},
      {"header.stamps", FieldKind::kTime,
       "std_msgs/Header has no field 'stamps'; its fields are seq, stamp"},
      {"header", FieldKind::kNumber, "is of type Header, not a number"},
      {"header.stamp", FieldKind::kNumber, "is of type time, not a number"},
      {"header.seq", FieldKind::kTime, "is of type uint32, not a time"},
      {"header.stamp.secs", FieldKind::kNumber, "is of type time and has no fields"},
      {"header[0].stamp", FieldKind::kTime, "header is not an array"},
      {"animals.name", FieldKind::kText, "write animals[0] or animals[]"},
      {"animals[].size", FieldKind::kNumber, "write size[0] or size[]"},
      {"animals[].size", FieldKind::kText, "write size[0] or size[]"},
      {"animals[].size[0]", FieldKind::kText, "is of type float32[2], not a string"},
      {"animals[].size[2]", FieldKind::kNumber, "size has 2 elements"},
      {"animals[x].name", FieldKind::kText, "'[x]' is not an index"},
      {"animals[0.name", FieldKind::kText, "'[0' is not an index"},
      {"animals[].tag", FieldKind::kNumber, "write tag[0] or tag[]"}};
  for (const auto& [path, kind, complaint] : cases) {
    EXPECT_THAT(complaintOf(kCage, {{path, kind}}),
                testing::AllOf(HasSubstr(std::string("field ") + path), HasSubstr(complaint)));
  }
}

}  // namespace
}  // namespace forge
