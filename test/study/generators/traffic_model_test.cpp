#include "collision_forge/study/generators/make_traffic_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "study/generators/sample_traffic.h"

namespace forge {
namespace {

TEST(MakeTrafficModel, NamesTheKnownOnes) {
  try {
    makeTrafficModel("c_unknown", shippedConfig().generators, torch::kCPU, 0);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(),
                testing::AllOf(testing::HasSubstr("c_unknown"), testing::HasSubstr("c_sgan")));
  }
}

TEST(NoiseOf, IsThatOfItsSeed) {
  const torch::Tensor first = torch::randn({5}, noiseOf(3));
  EXPECT_TRUE(torch::equal(first, torch::randn({5}, noiseOf(3))));
  EXPECT_FALSE(torch::equal(first, torch::randn({5}, noiseOf(4))));
}

}  // namespace
}  // namespace forge
