#include "collision_forge/base/geometry/enum_words.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

enum class Fruit { kApple, kPear, kPlum };
constexpr EnumWord<Fruit> kFruits[] = {{Fruit::kApple, "apple"}, {Fruit::kPear, "pear"}};

TEST(EnumWords, MapsWordsToValues) {
  for (const auto& [value, word] : kFruits) {
    EXPECT_STREQ(wordOf(kFruits, value), word);
    EXPECT_EQ(valueOf(kFruits, word), value);
  }
}

TEST(EnumWords, ReportsUnknownWordsAndValues) {
  EXPECT_STREQ(wordOf(kFruits, Fruit::kPlum), "unknown");
  EXPECT_STREQ(wordOf(kFruits, Fruit::kPlum, "NONE"), "NONE");
  EXPECT_EQ(valueOf(kFruits, "plum"), std::nullopt);
  EXPECT_EQ(valueOf(kFruits, "Apple"), std::nullopt);
}

}  // namespace
}  // namespace forge
