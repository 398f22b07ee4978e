#include "collision_forge/planner_test/planners/red_lights.h"

#include <gtest/gtest.h>

#include "collision_forge/planner_test/planners/idm.h"
#include "collision_forge/planner_test/planners/pdm_planner.h"
#include "planner_test/planners/planner_scenes.h"

namespace forge {
namespace {

/// A lane of 60 m along x, then one of 40 m through a junction with a light.
std::shared_ptr<const LaneIndex> roadToJunction() {
  auto map = std::make_shared<LaneMap>();
  Lane before;
  before.id = "before";
  before.outgoing = {"junction"};
  for (int i = 0; i <= 60; ++i) before.centerline.push_back({static_cast<double>(i), 0.0, 0.0});
  Lane junction;
  junction.id = "junction";
  junction.is_connector = true;
  junction.incoming = {"before"};
  for (int i = 60; i <= 100; ++i) junction.centerline.push_back({static_cast<double>(i), 0.0, 0.0});
  map->lanes = {before, junction};
  map->drivable_area = {rectangle(0.0, -2.0, 100.0, 2.0)};
  return std::make_shared<const LaneIndex>(map);
}

const std::vector<std::size_t> kRoute = {0, 1};

std::vector<Track> agentsWithEgoAt(double x, const std::vector<std::string>& red_lanes) {
  const Observation observation{egoAt({x, 0.0, 0.0}, 8.0), {}, red_lanes};
  return withRedLights(observation, {4.0, 1.8}, *roadToJunction(), kRoute);
}

TEST(RedLights, StandBehindTheStopLineOfTheirLane) {
  const std::vector<Track> agents = agentsWithEgoAt(20.0, {"junction", "elsewhere"});
  ASSERT_EQ(agents.size(), 1U);
  EXPECT_TRUE(isRedLight(agents[0].id));
  EXPECT_EQ(agents[0].agent_class, AgentClass::kStaticObject);
  EXPECT_NEAR(agents[0].states.back().pose.x - 0.5 * agents[0].size.length, 60.0, 1e-9);
}

TEST(RedLights, DoNotConcernAnEgoThatHasPassedTheLine) {
  EXPECT_EQ(agentsWithEgoAt(57.9, {"junction"}).size(), 1U);
  EXPECT_TRUE(agentsWithEgoAt(58.1, {"junction"}).empty());
}

/// Returns where a planner's plan for a red or green light ends, m along x.
double endOf(Planner&& planner, const std::vector<std::string>& red_lanes) {
  DrivingTask task = taskOn(roadToJunction());
  task.route = {{0.0, 0.0}, {100.0, 0.0}};
  planner.initialize(task);
  return planner.plan({egoAt({30.0, 0.0, 0.0}, 8.0), {}, red_lanes}).back().pose.x;
}

TEST(RedLights, StopIdmAndPdm) {
  const PlannerOptions& options = shippedConfig().planners;
  const double front = 0.5 * taskOn(roadToJunction()).ego.size.length;
  for (const bool is_red : {true, false}) {
    const std::vector<std::string> red =
        is_red ? std::vector<std::string>{"junction"} : std::vector<std::string>{};
    const double idm = endOf(IdmPlanner(options.idm, options.route_centerline), red);
    const double pdm =
        endOf(PdmPlanner(options.pdm, options.route_centerline, options.car, options.lqr), red);
    EXPECT_EQ(idm + front < 60.0, is_red) << idm;
    EXPECT_EQ(pdm + front < 60.0, is_red) << pdm;
  }
}

}  // namespace
}  // namespace forge
