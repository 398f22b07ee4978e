#include "collision_forge/base/config/nearest_names.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

const std::vector<std::string> kModes = {"history", "replay", "adaptive"};

TEST(EditDistance, CountsInsertionsDeletionsReplacementsAndSwaps) {
  EXPECT_EQ(editDistance("", ""), 0u);
  EXPECT_EQ(editDistance("", "abc"), 3u);
  EXPECT_EQ(editDistance("abc", "abc"), 0u);
  EXPECT_EQ(editDistance("abc", "abxc"), 1u);
  EXPECT_EQ(editDistance("abc", "ac"), 1u);
  EXPECT_EQ(editDistance("abc", "axc"), 1u);
  EXPECT_EQ(editDistance("abc", "acb"), 1u);
  EXPECT_EQ(editDistance("kitten", "sitting"), 3u);
}

TEST(EditDistance, IsTheSameBothWays) {
  for (const std::string a : {"scene-0001", "cut_in", "a"}) {
    for (const std::string b : {"scene-0010", "cutin", ""}) {
      EXPECT_EQ(editDistance(a, b), editDistance(b, a)) << a << " " << b;
    }
  }
}

TEST(NearestName, IsTheOneWithFewestEdits) {
  EXPECT_EQ(nearestName("repaly", kModes), "replay");
  EXPECT_EQ(nearestName("HISTRY", kModes), "history");
  EXPECT_EQ(nearestName("cat", {"cart", "cast"}), "cart");
}

TEST(NearestName, MayBeginWithTheWordOrTheWordWithIt) {
  EXPECT_EQ(nearestName("adapt", kModes), "adaptive");
  EXPECT_EQ(nearestName("--output", {"--config", "--out"}), "--out");
}

TEST(NearestName, IsNoneWhereEveryNameIsFar) {
  EXPECT_EQ(nearestName("live", kModes), std::nullopt);
  EXPECT_EQ(nearestName("x", {}), std::nullopt);
}

TEST(NearestName, IsFormattedAsAHint) {
  EXPECT_EQ(nearestNameHint("repaly", kModes), "; did you mean replay?");
  EXPECT_EQ(nearestNameHint("live", kModes), "");
}

}  // namespace
}  // namespace forge
