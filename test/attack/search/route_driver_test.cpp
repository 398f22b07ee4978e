#include "collision_forge/attack/search/route_driver.h"

#include <gtest/gtest.h>

#include <cmath>

#include "attack/search/test_scenes.h"

namespace forge {
namespace {

constexpr double kStep = 0.1;
constexpr std::size_t kSteps = 60;

class RouteTest : public testing::Test {
 protected:
  /// Along x from 0 on, then around a bend of radius 12 m to the left, then north.
  static Polyline bend() {
    std::vector<Vector2> points;
    for (double x = 0.0; x < 60.0; x += 1.0) points.emplace_back(x, 0.0);
    for (double angle = 0.0; angle < M_PI_2; angle += 0.08) {
      points.emplace_back(60.0 + 12.0 * std::sin(angle), 12.0 - 12.0 * std::cos(angle));
    }
    for (double y = 13.0; y < 80.0; y += 1.0) points.emplace_back(72.0, y);
    return Polyline(points);
  }

  RouteDriver routeAt(double x, double y, double speed) const {
    DriveState now;
    now.axle = {x - limits_.axle_to_middle, y, 0.0};
    now.speed = speed;
    return {ReferencePath(bend()), now, limits_};
  }

  /// The style by which it was planned.
  static std::optional<std::size_t> plan(const RouteDriver& route, const RoutePlan& wanted,
                                         std::vector<PlannedStep>& planned) {
    RouteReach reach;
    const auto speed = route.speedFor(wanted, kStep, reach);
    if (!speed) return std::nullopt;
    route.plan(wanted, route.courseAt(wanted, *speed, kStep), kStep, kSteps, planned);
    return speed->style;
  }

  static double speedAt(const std::vector<PlannedStep>& planned, std::size_t i) {
    return (planned[i + 1].middle - planned[i].middle).norm() / kStep;
  }

  const DriveLimits limits_ =
      driveLimitsOf(AgentClass::kCar, kCarSize, shippedOptions().verification.drivable);
};

TEST_F(RouteTest, ArrivesInTimeAtTheRequestedOffsetAndHeading) {
  const RouteDriver route = routeAt(2.0, 0.3, 8.0);
  RoutePlan wanted;
  wanted.arrival = 4.0;
  wanted.at = {38.0, 2.0, 0.2};
  wanted.departure = 1.5;
  std::vector<PlannedStep> planned;
  ASSERT_TRUE(plan(route, wanted, planned));
  ASSERT_EQ(planned.size(), kSteps);
  EXPECT_NEAR(planned[40].middle.x(), 38.0, 0.4);
  EXPECT_NEAR(planned[40].middle.y(), 2.0, 0.1);
  EXPECT_NEAR(planned[40].pose().yaw, 0.2, 0.02);
  for (std::size_t i = 0; i <= 24; ++i) {
    EXPECT_LT(std::abs(planned[i].middle.y() - 0.3), 0.2)
        << "keeps its offset until it departs, " << i;
  }
}

TEST_F(RouteTest, StartsWhereItIsIfTheArrivalIsLessThanAStepAway) {
  const RouteDriver route = routeAt(2.0, 0.3, 8.0);
  RoutePlan wanted;
  wanted.arrival = 0.5 * kStep;
  wanted.at = {2.4, 1.0, 0.0};
  for (const double departure : {0.25 * kStep, 0.5 * kStep, 20.0 * kStep}) {
    wanted.departure = departure;
    std::vector<PlannedStep> planned;
    ASSERT_TRUE(plan(route, wanted, planned));
    EXPECT_NEAR(planned[0].middle.y(), 0.3, 1e-9) << departure;
  }
}

TEST_F(RouteTest, UsesTheGentlestStyleThatArrives) {
  const RouteDriver route = routeAt(2.0, 0.0, 8.0);
  std::vector<PlannedStep> planned;
  RoutePlan wanted;
  wanted.arrival = 4.0;
  wanted.at = {34.0, 0.0, 0.0};
  EXPECT_EQ(plan(route, wanted, planned), std::size_t{0}) << "as it drives now";
  std::size_t wildest = 0;
  for (wanted.at.along = 35.0; wanted.at.along < 58.0; wanted.at.along += 1.0) {
    const auto style = plan(route, wanted, planned);
    if (!style) break;
    EXPECT_GE(*style, wildest) << "the farther, the harder";
    wildest = *style;
  }
  EXPECT_EQ(wildest + 1, kDrivingStyles.size());
  wanted.at.along = 90.0;
  EXPECT_FALSE(plan(route, wanted, planned)) << "nobody gets there";
  wanted.at.along = 8.0;
  EXPECT_FALSE(plan(route, wanted, planned)) << "nobody stops so soon";
}

TEST_F(RouteTest, SlowsDownForABend) {
  const RouteDriver route = routeAt(20.0, 0.0, 12.0);
  std::vector<PlannedStep> planned;
  RoutePlan wanted;
  wanted.arrival = 5.5;
  wanted.at = {66.0, 0.0, 0.0};
  const auto style = plan(route, wanted, planned);
  ASSERT_TRUE(style);
  const double lateral = kDrivingStyles[*style].lateral;
  for (std::size_t i = 0; i + 6 < planned.size(); ++i) {
    if (planned[i].middle.x() < 62.0) continue;
    EXPECT_LT(speedAt(planned, i), 1.25 * std::sqrt(lateral * 12.0)) << i;
  }
}

TEST_F(RouteTest, BrakesLateOnRequest) {
  const RouteDriver route = routeAt(2.0, 0.0, 10.0);
  std::vector<PlannedStep> planned;
  RoutePlan wanted;
  wanted.arrival = 4.0;
  wanted.at = {36.0, 0.0, 0.0};
  wanted.late = 1.5;
  wanted.late_acceleration = -4.0;
  ASSERT_TRUE(plan(route, wanted, planned));
  EXPECT_NEAR(planned[40].middle.x(), 36.0, 0.4);
  EXPECT_LT(speedAt(planned, 38) + 3.0, speedAt(planned, 24));
}

TEST_F(RouteTest, AStandingVehicleMayWait) {
  const RouteDriver route = routeAt(2.0, 0.0, 0.0);
  std::vector<PlannedStep> planned;
  RoutePlan wanted;
  wanted.arrival = 5.0;
  wanted.wait = 2.5;
  wanted.at = {5.0, 0.0, 0.0};
  ASSERT_TRUE(plan(route, wanted, planned));
  for (std::size_t i = 0; i <= 25; ++i) EXPECT_NEAR(planned[i].middle.x(), 2.0, 1e-6) << i;
  EXPECT_NEAR(planned[50].middle.x(), 5.0, 0.4);
}

}  // namespace
}  // namespace forge
