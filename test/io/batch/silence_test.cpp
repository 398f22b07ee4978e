#include "collision_forge/io/batch/silence.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

TEST(Silence, ReturnsTheSilentRank) {
  Silence silence(3, 1.0);
  for (const int other : {1, 2}) silence.expect(other);
  for (int second = 0; second < 5; ++second) {
    silence.pass(1.0);
    silence.reset(1);
  }
  EXPECT_EQ(silence.longerThan(5.0), std::nullopt);
  EXPECT_EQ(silence.longerThan(4.5), 2);
}

TEST(Silence, IgnoresRanksThatLeftOrHaveNotJoined) {
  Silence silence(2, 1.0);
  silence.expect(0);
  silence.leave(0);
  silence.pass(1.0);
  EXPECT_TRUE(silence.hasLeft(0));
  EXPECT_TRUE(silence.hasLeft(1));
  EXPECT_EQ(silence.longerThan(0.5), std::nullopt);
}

TEST(Silence, IgnoresTimeInWhichThisProcessWasPaused) {
  Silence silence(1, 1.0);
  silence.expect(0);
  silence.pass(3600.0);
  EXPECT_EQ(silence.longerThan(1.5), std::nullopt);
}

}  // namespace
}  // namespace forge
