#include "collision_forge/study/dataset/balance.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <numeric>
#include <stdexcept>

namespace forge {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

using Counts = std::vector<std::size_t>;

std::size_t sum(const Counts& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

TEST(Balance, LevellingCutsTheLargestGroupsToOneSize) {
  EXPECT_THAT(levelledCounts({10, 3, 8, 0}, 15), ElementsAre(6, 3, 6, 0));
  EXPECT_THAT(levelledCounts({10, 3, 8}, 16), ElementsAre(7, 3, 6));
  EXPECT_THAT(levelledCounts({10, 3, 8}, 21), ElementsAre(10, 3, 8));
  EXPECT_THAT(levelledCounts({10, 3, 8}, 0), ElementsAre(0, 0, 0));
  EXPECT_THAT(levelledCounts({}, 5), IsEmpty());
}

TEST(Balance, MinShareKeepsAsManyAsPossible) {
  for (const Counts& available : std::vector<Counts>{
           {100, 100, 100, 100, 30}, {1000, 7, 40, 41, 8}, {5, 5, 5, 5, 5}, {900, 1, 1, 1, 1}}) {
    const double share = 0.15;
    const Counts counts = withMinShare(available, share);
    const std::size_t least = *std::min_element(counts.begin(), counts.end());
    EXPECT_EQ(least, *std::min_element(available.begin(), available.end()));
    EXPECT_GE(static_cast<double>(least), share * static_cast<double>(sum(counts)));
    if (counts == available) continue;
    EXPECT_LT(static_cast<double>(least), share * static_cast<double>(sum(counts) + 1));
  }
}

TEST(Balance, ImpossibleSharesAreRejected) {
  EXPECT_THROW(withMinShare({5, 5, 5}, 0.34), std::invalid_argument);
  EXPECT_NO_THROW(withMinShare({5, 5, 5}, 1.0 / 3.0));
  EXPECT_THROW(withMaxRatio({5, 5}, 0.99), std::invalid_argument);
}

TEST(Balance, MaxRatioKeepsAsManyAsPossible) {
  for (const Counts& available :
       std::vector<Counts>{{100, 10, 10, 10}, {1, 2, 3, 50, 60, 0, 61}, {9}, {1, 1000}}) {
    const double ratio = 1.5;
    const Counts counts = withMaxRatio(available, ratio);
    const auto groups =
        static_cast<double>(available.size() - static_cast<std::size_t>(std::count(
                                                   available.begin(), available.end(), 0U)));
    const auto kept = [&](std::size_t cap) {
      Counts cut = available;
      for (std::size_t& count : cut) count = std::min(count, cap);
      return static_cast<double>(cap) <= ratio * static_cast<double>(sum(cut)) / groups;
    };
    const std::size_t largest = *std::max_element(counts.begin(), counts.end());
    const std::size_t most = *std::max_element(available.begin(), available.end());
    EXPECT_TRUE(kept(largest));
    for (std::size_t cap = largest + 1; cap <= most; ++cap) EXPECT_FALSE(kept(cap)) << cap;
    for (std::size_t i = 0; i < counts.size(); ++i) {
      EXPECT_EQ(counts[i], std::min(available[i], largest));
    }
  }
}

/// Many clips of each kind, fewest left turns, few of the shortest length.
std::vector<ClipKind> manyClips() {
  std::vector<ClipKind> clips;
  for (int i = 0; i < 400; ++i) {
    for (const CollisionType type : kCollisionTypes) {
      if (type == CollisionType::kLtap && i % 8 != 0) continue;
      clips.push_back({type, i % 20 == 0 ? 9 : 10 + i % 9});
    }
  }
  return clips;
}

TEST(Balance, ChosenClipsMeetBothLimits) {
  const std::vector<ClipKind> clips = manyClips();
  const auto chosen = chooseBalanced(clips, {0.15, 1.2}, 3);
  std::map<CollisionType, std::map<int, int>> counts;
  for (const std::size_t clip : chosen) ++counts[clips[clip].type][clips[clip].length];
  ASSERT_EQ(counts.size(), 5U);
  for (const auto& [type, lengths] : counts) {
    int of_type = 0;
    int most = 0;
    for (const auto& [length, count] : lengths) {
      of_type += count;
      most = std::max(most, count);
    }
    EXPECT_GE(of_type, 0.15 * static_cast<double>(chosen.size()));
    EXPECT_LE(most, 1.2 * of_type / static_cast<double>(lengths.size()) + 1.0);
  }
  EXPECT_TRUE(std::is_sorted(chosen.begin(), chosen.end()));
  EXPECT_EQ(std::adjacent_find(chosen.begin(), chosen.end()), chosen.end());
}

}  // namespace
}  // namespace forge
