#include "collision_forge/base/scene/map_limits.h"

#include <gmock/gmock.h>

#include "base/scene/shipped_limits.h"

namespace forge {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Lane laneTo(const std::string& id, double end) {
  Lane lane;
  lane.id = id;
  lane.centerline = {{0.0, 0.0, 0.0}, {end, 0.0, 0.0}};
  return lane;
}

TEST(MapLimits, ALaneBeyondTheLimitsAndItsLinksAreRemoved) {
  LaneMap map;
  map.lanes = {laneTo("near", 10.0), laneTo("far", 1e9)};
  map.lanes[0].outgoing = {"far"};
  map.lanes[1].incoming = {"near"};
  std::vector<std::string> warnings;
  keepWithin(map, shippedLimits(), &warnings);
  ASSERT_EQ(map.lanes.size(), 1U);
  EXPECT_THAT(map.lanes[0].outgoing, IsEmpty());
  EXPECT_THAT(warnings, ElementsAre("1 lane beyond the limits of input_limits.yaml left out"));
}

TEST(MapLimits, LanesThatAreAllBeyondTheLimitsStayForTheCheck) {
  LaneMap map;
  map.lanes = {laneTo("far", 1e9)};
  keepWithin(map, shippedLimits());
  EXPECT_THROW(checkMap(map, shippedLimits(), "town"), InputError);
}

TEST(MapLimits, ASpeedLimitBeyondTheLimitsIsRemoved) {
  LaneMap map;
  map.lanes = {laneTo("a", 10.0), laneTo("b", 10.0)};
  map.lanes[0].speed_limit = 13.9;
  map.lanes[1].speed_limit = 1e3;
  std::vector<std::string> warnings;
  keepWithin(map, shippedLimits(), &warnings);
  EXPECT_EQ(map.lanes[0].speed_limit, 13.9);
  EXPECT_FALSE(map.lanes[1].speed_limit);
  EXPECT_THAT(warnings,
              ElementsAre("1 speed limit beyond the limits of input_limits.yaml left out"));
}

TEST(MapLimits, AreasAndFeaturesBeyondTheLimitsAreRemoved) {
  const std::vector<Vector2> far{{0.0, 0.0}, {1e9, 0.0}, {0.0, 1.0}};
  const std::vector<Vector2> near{{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}};
  LaneMap map;
  map.drivable_area = {{near, {}}, {near, {far}}};
  map.walkways = {{far, {}}, {near, {}}};
  map.features = {{FeatureKind::kRoadEdge, far}, {FeatureKind::kMedian, near}};
  std::vector<std::string> warnings;
  keepWithin(map, shippedLimits(), &warnings);
  EXPECT_EQ(map.drivable_area.size(), 1U);
  EXPECT_EQ(map.walkways.size(), 1U);
  ASSERT_EQ(map.features.size(), 1U);
  EXPECT_EQ(map.features[0].kind, FeatureKind::kMedian);
  EXPECT_EQ(warnings.size(), 3U);
}

}  // namespace
}  // namespace forge
