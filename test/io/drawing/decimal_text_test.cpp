#include "collision_forge/io/drawing/decimal_text.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

TEST(DecimalText, RoundsAndSigns) {
  EXPECT_EQ(decimalText(3.14159, 2), "3.14");
  EXPECT_EQ(decimalText(-137.6, 0), "−138");
}

TEST(DecimalText, HasNoNegativeZero) {
  EXPECT_EQ(decimalText(-0.04, 1), "0.0");
  EXPECT_EQ(decimalText(-0.05, 2), "−0.05");
}

TEST(SignedSeconds, AlwaysHasASign) {
  EXPECT_EQ(signedSeconds(4.0, 1), "+4.0 s");
  EXPECT_EQ(signedSeconds(-1.25, 2), "−1.25 s");
  EXPECT_EQ(signedSeconds(-0.01, 1), "+0.0 s");
}

}  // namespace
}  // namespace forge
