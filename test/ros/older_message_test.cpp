#include "collision_forge/ros/bags/older_message.h"

#include <gtest/gtest.h>

#include "collision_forge/ros/bags/bag_error.h"

namespace forge {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes converted(const std::string& from, const std::string& to, const Bytes& bytes) {
  const MessageDefinition old("a/B", from);
  const MessageDefinition now("a/B", to);
  return convertMessage(old.message(), now.message(), bytes);
}

TEST(OlderMessage, FieldsAreFoundByName) {
  EXPECT_EQ(converted("uint8 a\nuint8 b\nuint8 c\n", "uint8 c\nuint16 new\nuint8 a\n", {1, 2, 3}),
            (Bytes{3, 0, 0, 1}));
}

TEST(OlderMessage, AFieldOfAnotherTypeIsEmpty) {
  EXPECT_EQ(converted("uint8 a\nuint8 b\n", "string a\nuint8[] b\n", {1, 2}),
            (Bytes{0, 0, 0, 0, 0, 0, 0, 0}));
}

TEST(OlderMessage, ElementsOfArraysAreConverted) {
  const std::string nested = "\n================\nMSG: a/C\n";
  EXPECT_EQ(converted("C[] all\nuint8 last" + nested + "string name\nuint8 old\n",
                      "C[] all\nuint8 last" + nested + "uint8 new\nstring name\n",
                      {2, 0, 0, 0, 1, 0, 0, 0, 'x', 7, 0, 0, 0, 0, 8, 9}),
            (Bytes{2, 0, 0, 0, 0, 1, 0, 0, 0, 'x', 0, 0, 0, 0, 0, 9}));
}

TEST(OlderMessage, AMessageThatEndsEarlyIsRefused) {
  for (const Bytes& bytes : {Bytes{}, Bytes{255, 255, 255, 255}, Bytes{2, 0, 0, 0, 1}}) {
    EXPECT_THROW(converted("uint8[] a\n", "uint8 b\nuint8[] a\n", bytes), BagError);
  }
}

}  // namespace
}  // namespace forge
