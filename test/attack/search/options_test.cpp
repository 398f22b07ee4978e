#include "collision_forge/attack/search/options.h"

#include <gtest/gtest.h>

#include "attack/search/test_scenes.h"
#include "collision_forge/attack/search/search_task.h"

namespace forge {
namespace {

TEST(SearchOptions, MarginsAreSmallerThanEveryBand) {
  const AttackOptions options = shippedOptions();
  for (const auto& [type, definition] : shippedCrash().types) {
    EXPECT_LT(2.0 * kHeadingMargin, definition.max_heading - definition.min_heading)
        << toString(type);
  }
  EXPECT_LT(options.search.time_margin, shippedCrash().time_tolerance);
  EXPECT_LT(kLimitMargin, 1.0);
}

TEST(SearchOptions, PredictionsLastAsLongAsAttacks) {
  EXPECT_GE(shippedOptions().prediction.tail, shippedOptions().search.tail);
}

TEST(SearchOptions, ConfidenceIsAtMostTheShareOfFuturesHit) {
  const std::vector<double>& curve = shippedOptions().search.confidence_curve;
  EXPECT_EQ(curve.front(), 0.0);
  EXPECT_LT(curve.back(), 1.0);
  EXPECT_LT(shippedCrash().min_confidence, curve.back());
}

TEST(NominalOptions, LaneChangesEndAtAnAngleOfTheDataSet) {
  EXPECT_NEAR(shippedOptions().nominal.lane_change_heading, 20.0 * M_PI / 180.0, 1e-4);
}

}  // namespace
}  // namespace forge
