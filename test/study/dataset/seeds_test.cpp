#include "collision_forge/study/dataset/seeds.h"

#include <gtest/gtest.h>

#include <set>

namespace forge {
namespace {

TEST(Seeds, DifferentTextsAndSeedsGiveDifferentSeeds) {
  std::set<std::uint64_t> seeds;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    for (int i = 0; i < 100; ++i) seeds.insert(seedOf(std::to_string(i), seed));
  }
  EXPECT_EQ(seeds.size(), 10000U);
  EXPECT_EQ(seedOf("scene-0001", 7), seedOf("scene-0001", 7));
}

TEST(Seeds, SharesAreUniformlyDistributed) {
  int counts[10] = {};
  for (std::uint64_t seed = 0; seed < 10000; ++seed) {
    const double share = shareOf(seed);
    ASSERT_GE(share, 0.0);
    ASSERT_LT(share, 1.0);
    ++counts[static_cast<int>(10.0 * share)];
  }
  for (const int count : counts) EXPECT_NEAR(count, 1000, 150);  // five deviations
}

}  // namespace
}  // namespace forge
