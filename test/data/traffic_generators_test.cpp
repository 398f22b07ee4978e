#include "collision_forge/data/traffic_generators.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace forge {
namespace {

TEST(AddGeneratorMethods, AddsAMethodForEachAndLoadsNothingYet) {
  MethodRegistry registry;
  addGeneratorMethods({"", "", "", {}, {{"c_sgan", "/absent.pt"}, {"own", ""}}, {}}, registry);
  EXPECT_THAT(registry.names(), testing::ElementsAre("c_sgan", "own"));
  EXPECT_TRUE(registry.at("c_sgan").is_seeded);
}

TEST(AddGeneratorMethods, OneWithoutAFileIsRefusedByName) {
  MethodRegistry registry;
  addGeneratorMethods({"", "", "", {}, {{"own", ""}}, {}}, registry);
  try {
    registry.at("own").make({});
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("own in models.yaml names no file"));
  }
}

}  // namespace
}  // namespace forge
