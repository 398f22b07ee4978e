#include "collision_forge/planner_test/planners/pdm_forecast.h"

#include <gtest/gtest.h>

#include <cmath>

#include "planner_test/planners/planner_scenes.h"

namespace forge {
namespace {

const OrientedBox kEgo{{0.0, 0.0, 0.0}, {4.084, 1.730}};

PdmAgentOptions agentOptions() { return shippedConfig().planners.pdm.agents; }

PdmForecast forecastOf(const std::vector<Track>& agents,
                       const PdmAgentOptions& options = agentOptions()) {
  std::set<std::string> ignored;
  return PdmForecast(agents, kEgo, 0.1, 40, options, ignored);
}

TEST(PdmForecast, AgentsDriveOnAlongOrAgainstTheirHeading) {
  Track agent = agentAt("a", {20.0, 5.0, 0.5}, 0.0);
  agent.states.back().velocity = {3.0, -1.0};
  const double way = 2.0 * std::sqrt(10.0);
  const OrientedBox box = forecastOf({agent}).box(0, 20);
  EXPECT_NEAR(box.center.x, 20.0 + way * std::cos(0.5), 1e-9);
  EXPECT_NEAR(box.center.y, 5.0 + way * std::sin(0.5), 1e-9);
  EXPECT_EQ(box.center.yaw, 0.5);
  EXPECT_EQ(box.size.length, kCarSize.length);
  agent.states.back().velocity = {-3.0, 1.0};
  EXPECT_NEAR(forecastOf({agent}).box(0, 20).center.x, 20.0 - way * std::cos(0.5), 1e-9);
}

TEST(PdmForecast, IsRenewedAtEveryOtherStep) {
  const PdmForecast forecast = forecastOf({agentAt("a", {20.0, 0.0, 0.0}, 10.0)});
  EXPECT_NEAR(forecast.box(0, 1).center.x, 20.0, 1e-9);
  EXPECT_NEAR(forecast.box(0, 2).center.x, 22.0, 1e-9);
  EXPECT_NEAR(forecast.box(0, 3).center.x, 22.0, 1e-9);
}

TEST(PdmForecast, WhoIsFartherThanTheRadiusIsNotSeen) {
  EXPECT_EQ(forecastOf({agentAt("a", {49.9, 0.0, 0.0}, 1.0)}).agents().size(), 1U);
  EXPECT_TRUE(forecastOf({agentAt("a", {50.1, 0.0, 0.0}, 1.0)}).agents().empty());
}

TEST(PdmForecast, TheNewestStateCounts) {
  Track agent = agentAt("a", {20.0, 0.0, 0.0}, 5.0);
  agent.states.insert(agent.states.begin(), {-0.5, {0.0, 30.0, 0.0}, {0.0, -60.0}});
  EXPECT_NEAR(forecastOf({agent}).box(0, 10).center.x, 25.0, 1e-9);
}

TEST(PdmForecast, WhoTouchesTheEgoIsIgnoredFromThenOn) {
  std::set<std::string> ignored;
  const std::vector<Track> touching = {agentAt("a", {4.0, 0.0, 0.0}, 0.0),
                                       agentAt("b", {9.0, 0.0, 0.0}, 0.0)};
  EXPECT_EQ(PdmForecast(touching, kEgo, 0.1, 40, agentOptions(), ignored).agents().size(), 1U);
  EXPECT_EQ(ignored, std::set<std::string>{"a"});
  const std::vector<Track> apart = {agentAt("a", {14.0, 0.0, 0.0}, 0.0)};
  EXPECT_TRUE(PdmForecast(apart, kEgo, 0.1, 40, agentOptions(), ignored).agents().empty());
}

TEST(PdmForecast, OfEachKindTheNearestAreLookedAt) {
  PdmAgentOptions options = agentOptions();
  options.vehicles = 2;
  options.pedestrians = 1;
  options.static_objects = 0;
  const BoxSize small{0.7, 0.7};
  const PdmForecast forecast =
      forecastOf({agentAt("far", {50.0, 0.0, 0.0}, 1.0), agentAt("near", {10.0, 0.0, 0.0}, 1.0),
                  agentAt("bus", {30.0, 0.0, 0.0}, 1.0, {12.0, 2.5}, AgentClass::kBus),
                  agentAt("walker", {20.0, 5.0, 0.0}, 1.0, small, AgentClass::kPedestrian),
                  agentAt("walker2", {12.0, 5.0, 0.0}, 1.0, small, AgentClass::kPedestrian),
                  agentAt("cone", {12.0, 9.0, 0.0}, 0.0, small, AgentClass::kStaticObject),
                  agentAt("bike", {40.0, 5.0, 0.0}, 1.0, small, AgentClass::kBicycle)},
                 options);
  std::vector<double> places;
  for (const ForecastAgent& agent : forecast.agents()) places.push_back(agent.box.center.x);
  EXPECT_EQ(places, (std::vector<double>{10.0, 30.0, 12.0, 40.0}));
}

TEST(PdmForecast, StandingAndStaticAreTold) {
  const PdmForecast forecast =
      forecastOf({agentAt("a", {20.0, 0.0, 0.0}, 0.04), agentAt("b", {30.0, 0.0, 0.0}, 0.06),
                  agentAt("c", {40.0, 0.0, 0.0}, 3.0, {1.0, 1.0}, AgentClass::kStaticObject)});
  EXPECT_EQ(forecast.agents().size(), 3U);
  EXPECT_TRUE(forecast.agents()[0].is_standing);
  EXPECT_FALSE(forecast.agents()[1].is_standing);
  EXPECT_FALSE(forecast.agents()[0].is_static_object);
  EXPECT_TRUE(forecast.agents()[2].is_static_object);
  EXPECT_TRUE(forecast.agents()[2].is_standing);
}

TEST(PdmForecast, AgentsWithoutAStateAreLeftOut) {
  EXPECT_TRUE(forecastOf({Track{"a", AgentClass::kCar, kCarSize, {}}}).agents().empty());
}

TEST(PdmForecast, VisitsWhomABoxTouches) {
  const PdmForecast forecast =
      forecastOf({agentAt("a", {20.0, 0.0, 0.0}, 0.0), agentAt("b", {49.0, 0.0, M_PI}, 7.0),
                  agentAt("c", {20.0, 2.5, 0.0}, 0.0)});
  std::vector<std::size_t> touched;
  forecast.forTouching({{22.0, 0.0, 0.0}, kEgo.size}, circumradius(kEgo.size), 40,
                       [&](std::size_t agent) { touched.push_back(agent); });
  EXPECT_EQ(touched, (std::vector<std::size_t>{0, 1}));
}

}  // namespace
}  // namespace forge
