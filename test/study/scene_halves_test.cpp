#include "collision_forge/study/scene_halves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace forge {
namespace {

std::vector<std::string> scenes(int count) {
  std::vector<std::string> names;
  for (int i = 0; i < count; ++i) names.push_back("scene-" + std::to_string(i));
  return names;
}

TEST(Shuffle, KeepsEveryValueOnce) {
  std::vector<std::string> values = scenes(20);
  std::mt19937_64 generator(1);
  shuffle(values, generator);
  EXPECT_NE(values, scenes(20));
  EXPECT_EQ(std::set<std::string>(values.begin(), values.end()).size(), 20u);
}

TEST(Shuffle, PutsEveryValueEverywhereAsOften) {
  constexpr int kDraws = 6000;
  std::mt19937_64 generator(2);
  int first_at[3] = {};
  for (int draw = 0; draw < kDraws; ++draw) {
    std::vector<int> values = {0, 1, 2};
    shuffle(values, generator);
    ++first_at[std::find(values.begin(), values.end(), 0) - values.begin()];
  }
  // Binomial with a share of a third: a standard deviation of 37.
  for (const int count : first_at) EXPECT_NEAR(count, kDraws / 3, 4 * 37) << "seed 2";
}

TEST(SceneHalves, DifferByOneAtMost) {
  for (const int count : {0, 1, 2, 7, 10}) {
    std::mt19937_64 generator(3);
    int second = 0;
    const SceneHalves halves = drawSceneHalves(scenes(count), generator);
    for (const auto& [scene, half] : halves) second += half;
    EXPECT_EQ(halves.size(), static_cast<std::size_t>(count));
    EXPECT_LE(std::abs(count - 2 * second), 1);
  }
}

TEST(SceneHalves, CountASceneOnceInWhateverOrder) {
  std::vector<std::string> twice = scenes(9);
  std::reverse(twice.begin(), twice.end());
  for (const std::string& scene : scenes(9)) twice.push_back(scene);
  std::mt19937_64 one(4), other(4);
  EXPECT_EQ(drawSceneHalves(scenes(9), one), drawSceneHalves(twice, other));
}

TEST(SceneHalves, DifferFromDrawToDraw) {
  std::mt19937_64 generator(5);
  EXPECT_NE(drawSceneHalves(scenes(20), generator), drawSceneHalves(scenes(20), generator));
}

}  // namespace
}  // namespace forge
