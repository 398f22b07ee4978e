#include "collision_forge/planner_test/planners/route.h"

#include <gtest/gtest.h>

#include "planner_test/trials/rollout_scenes.h"

namespace forge {
namespace {

const RouteOptions& options() { return shippedConfig().planners.planning.route; }

TEST(Route, FollowsTheRecordingThenTheLane) {
  const LaneIndex lanes(twoLaneRoad());
  const Track recorded =
      straightTrack(kEgoId, kEgoSize, {0.0, 0.5, 0.0}, 5.0, kNow, kNow, kNow + 4);
  const auto route = routeOf(recorded, lanes, options());
  EXPECT_NEAR(route[3].y(), 0.5, 1e-9);      // as driven
  EXPECT_NEAR(route.back().y(), 0.0, 1e-9);  // the lane's middle
  EXPECT_NEAR(route.back().x(), 20.0 + options().length_ahead, 1e-6);
  for (std::size_t i = 1; i < route.size(); ++i) EXPECT_GT(route[i].x(), route[i - 1].x());
}

TEST(Route, ContinuesStraightWhereNoLaneIsNear) {
  const LaneIndex lanes(emptyMap());
  const Track recorded =
      straightTrack(kEgoId, kEgoSize, {0.0, 0.0, 1.0}, 5.0, kNow, kNow, kNow + 1);
  const auto route = routeOf(recorded, lanes, options());
  const Vector2 expected = (5.0 + options().length_ahead) * Vector2(std::cos(1.0), std::sin(1.0));
  EXPECT_NEAR((route.back() - expected).norm(), 0.0, 1e-9);
}

TEST(Route, ContinuesStraightWhereTheLanesEnd) {
  auto map = emptyMap();
  map->lanes = {straightLane("ends", {-50, 0}, {40, 0})};
  const Track recorded =
      straightTrack(kEgoId, kEgoSize, {0.0, 0.0, 0.0}, 5.0, kNow, kNow, kNow + 4);
  const auto route = routeOf(recorded, LaneIndex(map), options());
  EXPECT_NEAR(route.back().x(), 20.0 + options().length_ahead, 1e-6);
  EXPECT_NEAR(route.back().y(), 0.0, 1e-9);
}

TEST(Route, FollowsTheLaneForAStandingCar) {
  const LaneIndex lanes(twoLaneRoad());
  const Track recorded =
      straightTrack(kEgoId, kEgoSize, {0.0, 0.0, 0.0}, 0.0, kNow, kNow, kNow + 4);
  EXPECT_GT(routeOf(recorded, lanes, options()).back().x(), 90.0);
}

TEST(Route, RejectsATrackWithoutStates) {
  const LaneIndex lanes(emptyMap());
  EXPECT_THROW(routeOf({kEgoId, AgentClass::kCar, kEgoSize, {}}, lanes, options()),
               std::invalid_argument);
}

}  // namespace
}  // namespace forge
