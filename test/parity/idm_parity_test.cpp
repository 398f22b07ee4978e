#include <gtest/gtest.h>

#include <cmath>

#include "collision_forge/planner_test/planners/idm.h"
#include "parity/parity_fixture.h"
#include "planner_test/planners/planner_scenes.h"

namespace forge {
namespace {

using rapidjson::Value;

constexpr double kStepTolerance = 1e-6;
constexpr double kIntegralTolerance = 1e-4;
constexpr double kPlanTolerance = 1e-3;

/// The planner's parameters with those of a case in place.
IdmParameters lawOf(const ParityFixture& fixture, const Value* in = nullptr) {
  const Value& all = fixture.at("planner_parameters");
  const auto parameter = [&](const char* name) {
    const Value* own = in ? &memberOf(*in, "parameters") : nullptr;
    return numberOf(own && own->HasMember(name) ? *own : all, name);
  };
  IdmParameters law = shippedConfig().planners.idm.law;
  law.desired_speed = parameter("target_velocity");
  law.time_headway = parameter("headway_time");
  law.max_acceleration = parameter("accel_max");
  law.braking = parameter("decel_max");
  law.min_gap = parameter("min_gap_to_lead_agent");
  return law;
}

void expectState(const IdmState& state, const Value& expected, double tolerance) {
  EXPECT_NEAR(state.progress, numberOf(expected[0]), tolerance);
  EXPECT_NEAR(state.speed, numberOf(expected[1]), tolerance);
}

TEST(IdmParity, ShippedParametersAreNuPlans) {
  const ParityFixture fixture("idm_nuplan.json");
  SKIP_WITHOUT(fixture);
  const IdmParameters ours = shippedConfig().planners.idm.law;
  const IdmParameters theirs = lawOf(fixture);
  EXPECT_EQ(ours.desired_speed, theirs.desired_speed);
  EXPECT_EQ(ours.time_headway, theirs.time_headway);
  EXPECT_EQ(ours.max_acceleration, theirs.max_acceleration);
  EXPECT_EQ(ours.braking, theirs.braking);
  EXPECT_EQ(ours.min_gap, theirs.min_gap);
}

TEST(IdmParity, StepsAreNuPlans) {
  const ParityFixture fixture("idm_nuplan.json");
  SKIP_WITHOUT(fixture);
  for (const Value* one : fixture.cases("steps")) {
    const Value& in = memberOf(*one, "in");
    const Value& out = memberOf(*one, "out");
    const IdmParameters law = lawOf(fixture, &in);
    const double speed = numberOf(in, "speed");
    const double duration = numberOf(in, "dt");
    const IdmLead lead{numberOf(in, "lead_progress") - numberOf(in, "lead_length_rear"),
                       numberOf(in, "lead_speed")};
    EXPECT_NEAR(nuplanIdmAcceleration(law, speed, lead), numberOf(out, "acceleration_unclipped"),
                kStepTolerance);
    expectState(eulerStep(law, {0.0, speed}, lead, duration), memberOf(out, "euler"),
                kStepTolerance);
    const auto rate = [&](const Eigen::Vector2d& state) {
      const IdmLead ahead{lead.gap - state[0], lead.speed};
      return Eigen::Vector2d(state[1], nuplanIdmAcceleration(law, state[1], ahead));
    };
    const auto expectIntegral = [&](const char* name, const IntegrationTolerance& tolerance) {
      if (!out.HasMember(name)) return;
      const Eigen::Vector2d state =
          integrateDormandPrince(rate, {0.0, speed}, duration, tolerance).state;
      expectState({state[0], state[1]}, out[name], kIntegralTolerance);
    };
    expectIntegral("rk45", shippedConfig().planners.published_idm.tolerance);
    expectIntegral("odeint", {1e-9, 1e-9});
  }
}

TEST(IdmParity, RolloutsAreNuPlans) {
  constexpr double kFarAway = 1e4;  // m, of the lead of a free road, at every step
  const ParityFixture fixture("idm_nuplan.json");
  SKIP_WITHOUT(fixture);
  for (const Value* one : fixture.cases("rollouts")) {
    const Value& in = memberOf(*one, "in");
    const Value& expected = memberOf(memberOf(*one, "out"), "progress_speed_at_steps_1_2_5_20_40");
    const IdmParameters law = lawOf(fixture, &in);
    const double duration = numberOf(in, "dt");
    const bool is_free = in["gap"].IsNull();
    const double lead_speed = is_free ? 0.0 : numberOf(in, "lead_speed");
    double lead_place = is_free ? 0.0 : numberOf(in, "gap");
    IdmState state{0.0, numberOf(in, "speed")};
    int step = 0;
    const int kept[] = {1, 2, 5, 20, 40};
    for (rapidjson::SizeType i = 0; i < expected.Size(); ++i) {
      for (; step < kept[i]; ++step) {
        const double gap = is_free ? kFarAway : lead_place - state.progress;
        state = eulerStep(law, state, {gap, lead_speed}, duration);
        state.speed = std::max(state.speed, 0.0);
        lead_place += lead_speed * duration;
      }
      expectState(state, expected[i], kStepTolerance);
    }
  }
}

Lane laneOf(const std::string& id, const Value& value) {
  Lane lane;
  lane.id = id;
  for (const Value& node : value["centerline"].GetArray()) lane.centerline.push_back(poseOf(node));
  for (const Value& point : value["polygon"].GetArray()) {
    lane.polygon.emplace_back(numberOf(point[0]), numberOf(point[1]));
  }
  for (const Value& next : value["next"].GetArray()) lane.outgoing.emplace_back(next.GetString());
  if (!value["speed_limit"].IsNull()) lane.speed_limit = numberOf(value, "speed_limit");
  return lane;
}

/// A lane of every road block of a route, each following the one before.
std::vector<Vector2> routeOf(const Value& map, const std::string& name) {
  std::vector<Vector2> points;
  std::string last;
  for (const Value& block : memberOf(map["routes"], name.c_str()).GetArray()) {
    for (const Value& lane : map["roadblocks"][block.GetString()]["lanes"].GetArray()) {
      bool follows = last.empty();
      if (!follows) {
        for (const Value& next : map["lanes"][last.c_str()]["next"].GetArray()) {
          follows = follows || next == lane;
        }
      }
      if (!follows) continue;
      last = lane.GetString();
      for (const Value& node : map["lanes"][last.c_str()]["centerline"].GetArray()) {
        points.push_back(poseOf(node).position());
      }
      break;
    }
  }
  return points;
}

DrivingTask taskOf(const ParityFixture& maps, const Value& in, const ParityVehicle& vehicle) {
  const Value& map = maps.at(textOf(in, "map").c_str());
  auto lanes = std::make_shared<LaneMap>();
  for (const auto& lane : map["lanes"].GetObject()) {
    lanes->lanes.push_back(laneOf(lane.name.GetString(), lane.value));
  }
  return {std::make_shared<const LaneIndex>(lanes), routeOf(map, textOf(in, "route")), vehicle.ego,
          vehicle.wheelbase};
}

TEST(IdmParity, PlansAreNuPlans) {
  const ParityFixture fixture("idm_nuplan.json");
  const ParityFixture maps("maps.json");
  SKIP_WITHOUT(fixture);
  SKIP_WITHOUT(maps);
  const PlannerOptions& options = shippedConfig().planners;
  double worst = 0.0;
  for (const Value* one : fixture.cases("planner")) {
    const Value& in = memberOf(*one, "in");
    const ParityVehicle vehicle = vehicleOf(fixture, textOf(in, "vehicle"));
    const Pose2 middle = compose(poseOf(in["rear_axle"]), {vehicle.ego.center_offset, 0.0, 0.0});
    Observation observation{egoAt(middle, numberOf(in, "speed")), {}};
    for (const Value& agent : in["agents"].GetArray()) {
      observation.agents.push_back(agentOf(agent, 0.0));
    }
    IdmPlanner planner(options.idm, options.route_centerline);
    planner.initialize(taskOf(maps, in, vehicle));
    const auto plan = planner.plan(observation);
    const Value& out = memberOf(*one, "out");
    EXPECT_NEAR(planner.targetSpeed(), numberOf(out, "target_velocity"), kStepTolerance);
    const Value& expected = memberOf(out, "center_x_y_heading_speed_every_s");
    ASSERT_EQ(plan.size(), 2 * expected.Size() - 1);
    for (rapidjson::SizeType i = 0; i < expected.Size(); ++i) {
      const TrajectoryPoint& point = plan[2 * i];
      const Pose2 pose = poseOf(expected[i]);
      EXPECT_NEAR(point.time, 1.0 * i, 1e-9);
      for (const double deviation :
           {point.pose.x - pose.x, point.pose.y - pose.y, angleBetween(pose.yaw, point.pose.yaw),
            point.speed - numberOf(expected[i][3])}) {
        worst = std::max(worst, std::abs(deviation));
        EXPECT_LE(std::abs(deviation), kPlanTolerance)
            << textOf(in, "map") << " from " << middle.x << ", " << middle.y << " after " << i;
      }
    }
  }
  RecordProperty("worst_deviation", std::to_string(worst));
}

}  // namespace
}  // namespace forge
