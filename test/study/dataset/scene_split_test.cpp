#include "collision_forge/study/dataset/scene_split.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

const SplitOptions kShares{0.7, 0.1};

std::vector<std::string> scenes(int count) {
  std::vector<std::string> names;
  for (int i = 0; i < count; ++i) names.push_back("scene-" + std::to_string(i));
  return names;
}

std::map<std::string, int> sizes(const std::map<std::string, std::string>& splits) {
  std::map<std::string, int> counts;
  for (const auto& [scene, split] : splits) ++counts[split];
  return counts;
}

TEST(SceneSplit, SharesAreAsConfigured) {
  const std::map<std::string, int> expected = {{"test", 20}, {"train", 70}, {"val", 10}};
  EXPECT_EQ(sizes(splitByScene(scenes(100), kShares)), expected);
}

TEST(SceneSplit, SplitsAreNotContiguousInNameOrder) {
  const auto splits = splitByScene(scenes(100), kShares);
  const std::vector<std::string> names = scenes(100);
  int changes = 0;
  for (std::size_t i = 1; i < names.size(); ++i) {
    changes += splits.at(names[i]) != splits.at(names[i - 1]) ? 1 : 0;
  }
  EXPECT_GT(changes, 20);
}

TEST(SceneSplit, FewScenesStillFillEverySplit) {
  const std::map<std::string, int> expected = {{"test", 1}, {"train", 2}, {"val", 1}};
  EXPECT_EQ(sizes(splitByScene(scenes(4), kShares)), expected);
  EXPECT_EQ(sizes(splitByScene(scenes(1), kShares)), (std::map<std::string, int>{{"train", 1}}));
  EXPECT_TRUE(splitByScene({}, kShares).empty());
}

}  // namespace
}  // namespace forge
