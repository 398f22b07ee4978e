#include "collision_forge/base/scene/number_words.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

TEST(NumberWords, NumbersHaveNoZerosAtTheirEnd) {
  EXPECT_EQ(numberText(50.0), "50");
  EXPECT_EQ(numberText(4.5), "4.5");
  EXPECT_EQ(numberText(0.01), "0.01");
  EXPECT_EQ(numberText(-1.0), "-1");
}

TEST(NumberWords, NumbersHaveSixDigitsAtMost) { EXPECT_EQ(numberText(19.9999996), "20"); }

TEST(NumberWords, NounsAreInThePluralUnlessThereIsOne) {
  EXPECT_EQ(counted(0, "vehicle"), "0 vehicles");
  EXPECT_EQ(counted(1, "vehicle"), "1 vehicle");
  EXPECT_EQ(counted(2, "vehicle"), "2 vehicles");
  EXPECT_EQ(counted(1, "try", "tries"), "1 try");
  EXPECT_EQ(counted(2, "try", "tries"), "2 tries");
}

}  // namespace
}  // namespace forge
