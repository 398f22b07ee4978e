#include "collision_forge/attack/options.h"

#include <gtest/gtest.h>

#include "attack/test_scenes.h"

namespace forge {
namespace {

double degrees(double radians) { return radians * 180.0 / M_PI; }

void expectBand(CollisionType type, double min, double nominal, double max) {
  constexpr double kRounding = 0.01;  // degrees; the file has radians to four digits
  const TypeDefinition& definition = shippedOptions().collision_types.at(type);
  EXPECT_NEAR(degrees(definition.min_heading), min, kRounding) << toString(type);
  EXPECT_NEAR(degrees(definition.nominal_heading), nominal, kRounding) << toString(type);
  EXPECT_NEAR(degrees(definition.max_heading), max, kRounding) << toString(type);
}

TEST(CollisionTypes, HaveTheBandsOfTheProtocol) {
  expectBand(CollisionType::kLaneChange, 10.0, 15.0, 30.0);
  expectBand(CollisionType::kOppositeDirection, 170.0, 180.0, 180.0);
  expectBand(CollisionType::kRearEnd, 0.0, 0.0, 10.0);
  expectBand(CollisionType::kJunctionCrossing, 80.0, 90.0, 100.0);
  expectBand(CollisionType::kLtap, 80.0, 90.0, 100.0);
}

TEST(CollisionTypes, ACrossingComesFromTheSideAndALeftTurnFromTheOppositeDirection) {
  const TypeDefinition& crossing =
      shippedOptions().collision_types.at(CollisionType::kJunctionCrossing);
  const TypeDefinition& ltap = shippedOptions().collision_types.at(CollisionType::kLtap);
  EXPECT_NEAR(degrees(crossing.min_approach), 45.0, 0.01);
  EXPECT_NEAR(degrees(crossing.max_approach), 135.0, 0.01);
  EXPECT_EQ(ltap.min_approach, crossing.max_approach);
  EXPECT_NEAR(degrees(ltap.max_approach), 180.0, 0.01);
}

TEST(SearchOptions, MarginsLeaveRoomInEveryBand) {
  const AttackOptions options = shippedOptions();
  for (const auto& [type, definition] : options.collision_types) {
    EXPECT_LT(2.0 * options.search.heading_margin, definition.max_heading - definition.min_heading)
        << toString(type);
  }
  EXPECT_LT(options.search.time_margin, options.verification.time_tolerance);
  EXPECT_LT(options.search.limit_margin, 1.0);
}

TEST(SearchOptions, EverybodyIsPredictedForAsLongAsAnAttackDrivesOn) {
  EXPECT_GE(shippedOptions().prediction.tail, shippedOptions().search.tail);
}

TEST(SearchOptions, QuickSteeringIsTwiceTheRateOfVehicleModels) {
  constexpr double kWheelbase = 2.7;     // m
  constexpr double kSteeringRate = 0.4;  // rad/s; CommonRoad's v_delta
  EXPECT_NEAR(shippedOptions().search.quick_steering * kWheelbase, 2.0 * kSteeringRate, 0.02);
}

TEST(SearchOptions, ConfidencePromisesNoMoreThanTheShareOfFuturesHit) {
  const std::vector<double>& curve = shippedOptions().search.confidence_curve;
  EXPECT_EQ(curve.front(), 0.0);
  EXPECT_LT(curve.back(), 1.0);
  EXPECT_LT(shippedOptions().search.min_confidence, curve.back());
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
