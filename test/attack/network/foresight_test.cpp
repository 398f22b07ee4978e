#include "collision_forge/attack/network/network_ego_futures.h"

#include <gtest/gtest.h>

#include "attack/network/sample_network.h"
#include "collision_forge/attack/forecast/speed_forecaster.h"

namespace forge {
namespace {

std::vector<Track> sampled(const Foresight& foresight) {
  const Snapshot snapshot = junctionSnapshot();
  return NetworkEgoFutures(shippedEgoFutureOptions(), foresight)
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

TEST(Foresight, ATestSceneUsesTheNetworkTrainedWithoutIt) {
  PatternWeights fold = randomWeights(7);
  fold.left_out_scenes = {"scene-x"};
  const auto both =
      std::make_shared<const PatternNetwork>(randomWeights(5), std::vector<PatternWeights>{fold});
  const Foresight foresight{nullptr, both, {}};
  const Foresight alone{nullptr, std::make_shared<const PatternNetwork>(fold), {}};
  EXPECT_TRUE(areSame(sampled(foresight.withoutScene("scene-x")), sampled(alone)));
  EXPECT_TRUE(areSame(sampled(foresight.withoutScene("scene-y")), sampled(foresight)));
  EXPECT_FALSE(areSame(sampled(foresight), sampled(alone)));
}

TEST(Foresight, WithoutSceneCopiesNothingAndKeepsTheType) {
  PatternWeights fold = randomWeights(7);
  fold.left_out_scenes = {"scene-x"};
  const Foresight foresight{
      nullptr,
      std::make_shared<const PatternNetwork>(randomWeights(5), std::vector<PatternWeights>{fold}),
      CollisionType::kLtap};
  const Foresight without = foresight.withoutScene("scene-x");
  EXPECT_EQ(without.network, foresight.network->folds()[0]);
  EXPECT_EQ(foresight.withoutScene("scene-y").network, foresight.network);
  EXPECT_EQ(without.known_type, CollisionType::kLtap);
}

TEST(Foresight, ATestSceneUsesTheSpeedModelFittedWithoutIt) {
  const auto drivers = std::make_shared<const DriversOfAScene>();
  const Foresight foresight{drivers, nullptr, {}};
  EXPECT_NE(foresight.withoutScene("scene-x").speeds, drivers);
  EXPECT_EQ(foresight.withoutScene("scene-y").speeds, drivers);
  EXPECT_EQ(Foresight{}.withoutScene("scene-x").speeds, nullptr);
}

}  // namespace
}  // namespace forge
