#include "collision_forge/io/batch/ranks.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

// Runs twice, as dispatch_test.cpp: in one process, and in three ranks.

TEST(Ranks, SumsAreTheSameForAll) {
  const Ranks& ranks = Ranks::get();
  std::vector<double> numbers = {1.0, 10.0 * ranks.rank(), 0.1};
  ranks.sum(numbers);
  const int size = ranks.size();
  EXPECT_EQ(numbers[0], size);
  EXPECT_EQ(numbers[1], 5.0 * size * (size - 1));
  EXPECT_NEAR(numbers[2], 0.1 * size, 1e-12);
}

}  // namespace
}  // namespace forge
