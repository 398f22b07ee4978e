#include "collision_forge/io/weights/traffic_generators.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace forge {
namespace {

TEST(AddGeneratorMethods, AddsTheMethodsOfEachAndLoadsNothingYet) {
  MethodRegistry registry;
  addGeneratorMethods({"", "", "", {}, {{"c_strive", {"/absent.pt"}}, {"c_sgan", {}}}, {}},
                      registry);
  EXPECT_THAT(registry.names(), testing::ElementsAre("c_sgan", "c_strive", "strive_optimised"));
  EXPECT_TRUE(registry.at("c_sgan").is_seeded);
}

TEST(AddGeneratorMethods, OneWithoutAFileIsRefusedByName) {
  MethodRegistry registry;
  addGeneratorMethods({"", "", "", {}, {{"c_sgan", {}}}, {}}, registry);
  try {
    registry.at("c_sgan").make({});
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("c_sgan in models.yaml names no file"));
  }
}

}  // namespace
}  // namespace forge
