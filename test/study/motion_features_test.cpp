#include "collision_forge/study/motion_features.h"

#include <gtest/gtest.h>

#include "study/test_windows.h"

namespace forge {
namespace {

const MotionOptions kOptions = shippedScorecardOptions().motion;

std::vector<double> featuresOf(const MotionWindow& window) {
  return motionFeatures(motionOf(window, kOptions));
}

void expectNear(const std::vector<double>& some, const std::vector<double>& others) {
  ASSERT_EQ(some.size(), others.size());
  for (std::size_t i = 0; i < some.size(); ++i) EXPECT_NEAR(some[i], others[i], 1e-6) << i;
}

TEST(MotionFeatures, KnowNothingOfPlaceTimeClassAndSide) {
  const MotionWindow window = simpleWindow("here", 8.0, 1.0, 0.2);
  MotionWindow moved = window;
  moved.scene = "there";
  moved.agent_class = AgentClass::kTruck;
  for (WindowSample& sample : moved.samples) {
    sample.time += 77.0;
    sample.pose = compose({300.0, -900.0, 2.0}, sample.pose);
  }
  expectNear(featuresOf(window), featuresOf(moved));
  expectNear(featuresOf(window), featuresOf(simpleWindow("here", 8.0, 1.0, -0.2)));
}

TEST(MotionFeatures, TellBrakingFromAcceleratingAndTurningFromStraight) {
  EXPECT_NE(featuresOf(simpleWindow("a", 8.0, 1.0)), featuresOf(simpleWindow("a", 8.0, -1.0)));
  EXPECT_NE(featuresOf(simpleWindow("a", 8.0, 1.0)), featuresOf(simpleWindow("a", 8.0, 1.0, 0.1)));
}

TEST(MotionFeatures, DoNotSeeNoiseThatTheFitTakesAway) {
  // At even times a sample's part in a cubic's residual is (-1)^i times a binomial of the order 6:
  // sixth differences see it, cubics do not.
  const double outside[kWindowSamples] = {1, -6, 15, -20, 15, -6, 1};
  const MotionWindow window = simpleWindow("a", 8.0, 1.0, 0.1);
  MotionWindow noisy = window;
  for (std::size_t i = 0; i < kWindowSamples; ++i) {
    noisy.samples[i].pose.x += 0.01 * outside[i];
    noisy.samples[i].pose.y -= 0.005 * outside[i];
  }
  expectNear(featuresOf(window), featuresOf(noisy));
}

TEST(MotionFeatures, DoNotSeeWhatIsSmallAgainstTheNoise) {
  expectNear(featuresOf(simpleWindow("a", 8.0, 0.0)),
             featuresOf(simpleWindow("a", 8.02, 0.01, 0.002)));
}

TEST(FeatureTables, HaveARowAWindow) {
  const auto motions =
      describeMotion({simpleWindow("a", 8.0, 1.0), simpleWindow("b", 4.0, 0.0, 0.1)}, kOptions);
  const FeatureTable table = featuresOf(motions);
  EXPECT_EQ(table.scenes, (std::vector<std::string>{"a", "b"}));
  ASSERT_EQ(table.features.rows(), 2);
  const std::vector<double> second = motionFeatures(motions[1].motion);
  ASSERT_EQ(table.features.cols(), static_cast<Eigen::Index>(second.size()));
  for (std::size_t i = 0; i < second.size(); ++i) EXPECT_EQ(table.features(1, i), second[i]);
  EXPECT_EQ(featuresOf(std::vector<DescribedMotion>{}).features.rows(), 0);
}

}  // namespace
}  // namespace forge
