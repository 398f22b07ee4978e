#include "collision_forge/study/generators/traffic_generator.h"

#include <gtest/gtest.h>

#include "study/generators/sample_traffic.h"

namespace forge {
namespace {

TEST(YawsAlong, FollowTheStepsAndStayInShortOnes) {
  const torch::Tensor steps =
      torch::tensor({1.0f, 1.0f, 0.1f, 0.0f, 0.0f, 2.0f}).view({1, 1, 3, 2});
  const torch::Tensor yaws = yawsAlong(steps, torch::zeros({1, 1}), 0.2);
  EXPECT_NEAR(yaws[0][0][0].item<double>(), M_PI_4, 1e-6);
  EXPECT_NEAR(yaws[0][0][1].item<double>(), M_PI_4, 1e-6);
  EXPECT_NEAR(yaws[0][0][2].item<double>(), M_PI_2, 1e-6);
}

}  // namespace
}  // namespace forge
