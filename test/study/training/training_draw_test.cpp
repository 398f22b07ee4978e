#include "collision_forge/study/training/training_draw.h"

#include <gtest/gtest.h>

#include <cmath>

namespace forge {
namespace {

constexpr int kDraws = 4000;

TrainingOptions drawOptions() {
  TrainingOptions options;
  options.times = 3;
  options.hidden_history_share = 0.3;
  options.mirrored_share = 0.5;
  options.noise_along = 0.2;
  options.noise_along_exponent = 2.0;
  options.noise_across = 0.1;
  return options;
}

TrainingSample moment() {
  TrainingSample sample;
  for (int i = 1; i <= 5; ++i) sample.times.push_back({1.0 * i, {}, {}});
  return sample;
}

TrainingSample clip(CollisionType type) {
  TrainingSample sample = moment();
  sample.attack.emplace();
  sample.attack->type = type;
  sample.attack->tta = 5.0;
  sample.attack->ego = {30.0, 4.0, M_PI_2};
  return sample;
}

template <typename Fact>
double shareOfDraws(const TrainingSample& sample, Fact fact) {
  std::mt19937_64 engine(1);
  int count = 0;
  for (int i = 0; i < kDraws; ++i) count += fact(randomDraw(sample, drawOptions(), engine));
  return static_cast<double>(count) / kDraws;
}

TEST(RandomDraw, ContainsTheImpactOfAnAttack) {
  const TrainingSample sample = clip(CollisionType::kRearEnd);
  std::mt19937_64 engine(1);
  const TrainingDraw draw = randomDraw(sample, drawOptions(), engine);
  ASSERT_EQ(draw.times.size(), 3U);
  EXPECT_EQ(draw.times[0], &sample.times.back());
  const TrainingSample log = moment();
  EXPECT_NEAR(shareOfDraws(log, [&](const TrainingDraw& d) { return d.times[0] == &log.times[0]; }),
              0.2, 0.03);
}

TEST(RandomDraw, HidesHistoriesOfClipsAndOfAShareOfLogs) {
  const auto hides = [](const TrainingDraw& draw) { return draw.hides_history; };
  EXPECT_EQ(shareOfDraws(clip(CollisionType::kRearEnd), hides), 1.0);
  EXPECT_NEAR(shareOfDraws(moment(), hides), 0.3, 0.03);
}

TEST(RandomDraw, MirrorsAllButLeftTurns) {
  const auto mirrors = [](const TrainingDraw& draw) { return draw.is_mirrored; };
  EXPECT_NEAR(shareOfDraws(moment(), mirrors), 0.5, 0.03);
  EXPECT_NEAR(shareOfDraws(clip(CollisionType::kLaneChange), mirrors), 0.5, 0.03);
  EXPECT_EQ(shareOfDraws(clip(CollisionType::kLtap), mirrors), 0.0);
}

TEST(EvenDraw, HasEvenlySpreadTimesAndNoAugmentation) {
  const TrainingSample sample = clip(CollisionType::kRearEnd);
  const TrainingDraw draw = evenDraw(sample, drawOptions());
  ASSERT_EQ(draw.times.size(), 3U);
  EXPECT_EQ(draw.times[0], &sample.times[4]);
  EXPECT_EQ(draw.times[1], &sample.times[2]);
  EXPECT_EQ(draw.times[2], &sample.times[0]);
  EXPECT_FALSE(draw.is_mirrored);
  EXPECT_TRUE(draw.hides_history);
  EXPECT_EQ(draw.expected_ego.x, 30.0);
  EXPECT_FALSE(evenDraw(moment(), drawOptions()).hides_history);
}

}  // namespace
}  // namespace forge
