#include "collision_forge/attack/search/options.h"

#include <gtest/gtest.h>

#include "attack/search/test_scenes.h"

namespace forge {
namespace {

TEST(SearchOptions, MarginsAreSmallerThanEveryBand) {
  const AttackOptions options = shippedOptions();
  for (const auto& [type, definition] : shippedCrash().types) {
    EXPECT_LT(2.0 * options.search.heading_margin, definition.max_heading - definition.min_heading)
        << toString(type);
  }
  EXPECT_LT(options.search.time_margin, shippedCrash().time_tolerance);
  EXPECT_LT(options.search.limit_margin, 1.0);
}

TEST(SearchOptions, PredictionsLastAsLongAsAttacks) {
  EXPECT_GE(shippedOptions().prediction.tail, shippedOptions().search.tail);
}

TEST(SearchOptions, QuickSteeringIsTwiceTheRateOfVehicleModels) {
  constexpr double kWheelbase = 2.7;     // m
  constexpr double kSteeringRate = 0.4;  // rad/s; CommonRoad's v_delta
  EXPECT_NEAR(shippedOptions().search.quick_steering * kWheelbase, 2.0 * kSteeringRate, 0.02);
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

TEST(SteeringOptions, ElitesArePartOfAPopulation) {
  const SteeringOptions options = shippedOptions().steering;
  EXPECT_LT(options.elites, options.population);
  EXPECT_LE(options.population, options.first_population);
  EXPECT_LE(options.considered, options.population);
  EXPECT_LT(options.near, options.hopeless);
}

}  // namespace
}  // namespace forge
