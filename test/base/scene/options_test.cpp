#include "collision_forge/base/scene/options.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "collision_forge/planner_test/settings/config.h"

namespace forge {
namespace {

const Config kShipped = loadConfig(COLLISION_FORGE_SOURCE_DIR "/config");

TEST(EgoVehicle, BaseLinkIsTheRearAxle) {
  constexpr double kRearOverhang = 0.657;  // m; Renault Zoe
  const EgoVehicle ego = kShipped.ego_vehicle;
  EXPECT_NEAR(ego.center_offset, 0.5 * ego.size.length - kRearOverhang, 1e-9);
}

double degrees(double radians) { return radians * 180.0 / M_PI; }

void expectBand(CollisionType type, double min, double nominal, double max) {
  constexpr double kRounding = 0.01;  // degrees; the file has radians to four digits
  const TypeDefinition& definition = kShipped.crash.types.at(type);
  EXPECT_NEAR(degrees(definition.min_heading), min, kRounding) << toString(type);
  EXPECT_NEAR(degrees(definition.nominal_heading), nominal, kRounding) << toString(type);
  EXPECT_NEAR(degrees(definition.max_heading), max, kRounding) << toString(type);
}

TEST(CrashDefinition, HaveTheBandsOfTheProtocol) {
  expectBand(CollisionType::kLaneChange, 10.0, 15.0, 30.0);
  expectBand(CollisionType::kOppositeDirection, 170.0, 180.0, 180.0);
  expectBand(CollisionType::kRearEnd, 0.0, 0.0, 10.0);
  expectBand(CollisionType::kJunctionCrossing, 80.0, 90.0, 100.0);
  expectBand(CollisionType::kLtap, 80.0, 90.0, 100.0);
}

TEST(CrashDefinition, EveryRelativeHeadingBelongsToAType) {
  for (int tenths = 0; tenths <= 1800; ++tenths) {
    const double heading = tenths * M_PI / 1800.0;
    EXPECT_TRUE(std::any_of(
        std::begin(kAllCollisionTypes), std::end(kAllCollisionTypes),
        [&](CollisionType type) { return headingFits(heading, kShipped.crash.types.at(type)); }))
        << tenths;
  }
}

TEST(CrashDefinition, ACrossingComesFromTheSideAndALeftTurnFromTheOppositeDirection) {
  const TypeDefinition& crossing = kShipped.crash.types.at(CollisionType::kJunctionCrossing);
  const TypeDefinition& ltap = kShipped.crash.types.at(CollisionType::kLtap);
  EXPECT_NEAR(degrees(crossing.min_approach), 45.0, 0.01);
  EXPECT_NEAR(degrees(crossing.max_approach), 135.0, 0.01);
  EXPECT_EQ(ltap.min_approach, crossing.max_approach);
  EXPECT_NEAR(degrees(ltap.max_approach), 180.0, 0.01);
}

TEST(CrashDefinition, ShippedRulesAreTheFullOnes) {
  EXPECT_EQ(kShipped.crash.rules, TypeRules::kFull);
}

}  // namespace
}  // namespace forge
