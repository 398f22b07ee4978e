#include "collision_forge/attack/network/network_ego_futures.h"

#include <gtest/gtest.h>

#include "attack/network/sample_network.h"
#include "collision_forge/attack/forecast/speed_forecaster.h"

namespace forge {
namespace {

std::vector<Track> sampled(const PredictionModels& models) {
  const Snapshot snapshot = junctionSnapshot();
  return NetworkEgoFutures(shippedEgoFutureOptions(), models)
      .sample(snapshot, lanesOf(snapshot), 6.0, 32, 0);
}

bool areSame(const std::vector<Track>& a, const std::vector<Track>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].states.back().pose.x != b[i].states.back().pose.x) return false;
  }
  return a.size() == b.size();
}

/// Drivers of scene-x, without a forecast.
class DriversOfAScene : public SpeedForecaster {
 public:
  SpeedForecast forecast(const DrivingSituation&, int) const override { return {}; }
  std::shared_ptr<const SpeedForecaster> withoutScene(const std::string& scene) const override {
    return scene == "scene-x" ? std::make_shared<DriversOfAScene>() : nullptr;
  }
};

TEST(PredictionModels, ATestSceneUsesTheNetworkTrainedWithoutIt) {
  PatternWeights fold = randomWeights(7);
  fold.left_out_scenes = {"scene-x"};
  const auto both =
      std::make_shared<const PatternNetwork>(randomWeights(5), std::vector<PatternWeights>{fold});
  const PredictionModels models{nullptr, both, {}};
  const PredictionModels alone{nullptr, std::make_shared<const PatternNetwork>(fold), {}};
  EXPECT_TRUE(areSame(sampled(models.withoutScene("scene-x")), sampled(alone)));
  EXPECT_TRUE(areSame(sampled(models.withoutScene("scene-y")), sampled(models)));
  EXPECT_FALSE(areSame(sampled(models), sampled(alone)));
}

TEST(PredictionModels, WithoutSceneCopiesNothingAndKeepsTheType) {
  PatternWeights fold = randomWeights(7);
  fold.left_out_scenes = {"scene-x"};
  const PredictionModels models{
      nullptr,
      std::make_shared<const PatternNetwork>(randomWeights(5), std::vector<PatternWeights>{fold}),
      CollisionType::kLtap};
  const PredictionModels without = models.withoutScene("scene-x");
  EXPECT_EQ(without.network, models.network->folds()[0]);
  EXPECT_EQ(models.withoutScene("scene-y").network, models.network);
  EXPECT_EQ(without.known_type, CollisionType::kLtap);
}

TEST(PredictionModels, ATestSceneUsesTheSpeedModelFittedWithoutIt) {
  const auto drivers = std::make_shared<const DriversOfAScene>();
  const PredictionModels models{drivers, nullptr, {}};
  EXPECT_NE(models.withoutScene("scene-x").speeds, drivers);
  EXPECT_EQ(models.withoutScene("scene-y").speeds, drivers);
  EXPECT_EQ(PredictionModels{}.withoutScene("scene-x").speeds, nullptr);
}

}  // namespace
}  // namespace forge
