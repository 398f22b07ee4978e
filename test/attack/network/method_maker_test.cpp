#include "collision_forge/attack/network/method_maker.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "attack/search/test_scenes.h"

namespace forge {
namespace {

TEST(MethodMaker, AnEmptyNameIsTheDefaultMethod) {
  EXPECT_EQ(MethodMaker("", builtInMethods(), shippedOptions(), {}).name(), "search");
}

TEST(MethodMaker, RejectsAMethodItCannotMake) {
  EXPECT_THROW(MethodMaker("nobody", builtInMethods(), shippedOptions(), {}),
               std::invalid_argument);
  EXPECT_THROW(MethodMaker("network+search", builtInMethods(), shippedOptions(), {}),
               std::invalid_argument);
}

TEST(MethodMaker, ReportsWhichMethodsAreSeeded) {
  const auto maker = [](const char* name) {
    return MethodMaker(name, builtInMethods(), shippedOptions(), {});
  };
  EXPECT_TRUE(maker("search").isSeeded());
  EXPECT_FALSE(maker("nominal").isSeeded());
}

}  // namespace
}  // namespace forge
