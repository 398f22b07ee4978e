#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

#include "collision_forge/planner_test/planners/pdm_planner.h"
#include "parity/pdm_world.h"
#include "planner_test/planners/planner_scenes.h"

namespace forge {
namespace {

constexpr double kScoreTolerance = 1e-3;
constexpr double kPoseTolerance = 0.01;

const PdmOptions& pdmOptions() { return shippedConfig().planners.pdm; }

std::vector<Track> agentsOf(const rapidjson::Value& in) {
  std::vector<Track> agents;
  for (const auto& agent : memberOf(in, "agents").GetArray()) agents.push_back(agentOf(agent, 0.0));
  return agents;
}

/// PDM-Closed in a car of the fixture.
PdmClosed plannerIn(const ParityVehicle& vehicle, PdmPath centerline) {
  KinematicBicycleOptions car = shippedConfig().planners.car;
  car.wheelbase = vehicle.wheelbase;
  return PdmClosed(std::move(centerline), vehicle.ego, car, shippedConfig().planners.lqr,
                   pdmOptions());
}

void expectAll(const std::vector<double>& values, const rapidjson::Value& expected,
               const char* name, double tolerance) {
  ASSERT_EQ(values.size(), expected.Size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_NEAR(values[i], numberOf(expected[static_cast<rapidjson::SizeType>(i)]), tolerance)
        << name << " of proposal " << i;
  }
}

template <typename Term>
std::vector<double> termsOf(const PdmClosed& planner, Term term) {
  std::vector<double> values;
  for (const PdmCandidate& candidate : planner.candidates()) values.push_back(term(candidate));
  return values;
}

void compareScores(const PdmClosed& planner, const rapidjson::Value& out) {
  const auto expect = [&](const char* name, auto term) {
    expectAll(termsOf(planner, term), memberOf(out, name), name, kScoreTolerance);
  };
  expect("scores", [](const PdmCandidate& candidate) { return candidate.score.total; });
  expect("no_at_fault_collision",
         [](const PdmCandidate& candidate) { return candidate.score.collision; });
  expect("drivable_area",
         [](const PdmCandidate& candidate) { return candidate.score.drivable_area; });
  expect("driving_direction",
         [](const PdmCandidate& candidate) { return candidate.score.driving_direction; });
  expect("progress", [](const PdmCandidate& candidate) { return candidate.score.progress; });
  expect("ttc", [](const PdmCandidate& candidate) { return candidate.score.time_to_collision; });
  expect("comfort", [](const PdmCandidate& candidate) { return candidate.score.comfort; });
}

void compareMotions(const PdmClosed& planner, const rapidjson::Value& out) {
  const auto proposals = memberOf(out, "proposal_progress_speed_at_4_s").GetArray();
  const auto simulated = memberOf(out, "simulated_x_y_heading_speed_at_4_s").GetArray();
  for (rapidjson::SizeType i = 0; i < proposals.Size(); ++i) {
    const PdmCandidate& candidate = planner.candidates().at(i);
    EXPECT_NEAR(candidate.proposal.states.back().progress, numberOf(proposals[i][0]),
                kPoseTolerance);
    EXPECT_NEAR(candidate.proposal.states.back().speed, numberOf(proposals[i][1]), kPoseTolerance);
    const BicycleState& last = candidate.motion.states.back();
    EXPECT_NEAR(last.rear_axle.x, numberOf(simulated[i][0]), kPoseTolerance);
    EXPECT_NEAR(last.rear_axle.y, numberOf(simulated[i][1]), kPoseTolerance);
    EXPECT_NEAR(last.speed, numberOf(simulated[i][3]), kPoseTolerance);
  }
}

TEST(PdmClosedParity, PlansAsThePublishedOne) {
  const ParityFixture fixture("pdm_closed.json");
  const ParityFixture maps("maps.json");
  SKIP_WITHOUT(fixture);
  SKIP_WITHOUT(maps);
  int number = 0;
  for (const rapidjson::Value* value : fixture.cases("plans")) {
    SCOPED_TRACE("plan " + std::to_string(number++));
    const rapidjson::Value& in = memberOf(*value, "in");
    const rapidjson::Value& out = memberOf(*value, "out");
    const ParityVehicle vehicle = vehicleOf(fixture, textOf(in, "vehicle"));
    const ParityMap world(maps, textOf(in, "map"));
    const rapidjson::Value& lanes = memberOf(in, "centerline_lanes");
    PdmClosed planner = plannerIn(vehicle, world.pathAlong(lanes));
    EXPECT_NEAR(planner.centerline().length(), numberOf(out, "centerline_length"), kPoseTolerance);
    const double limit = world.speedLimit(lanes[0].GetString(), pdmOptions().speed_limit);
    const std::vector<double> speeds = numbersOf(memberOf(out, "target_speeds"));
    for (std::size_t i = 0; i < speeds.size(); ++i) {
      EXPECT_NEAR(pdmOptions().speed_shares[i] * limit, speeds[i], 1e-6);
    }
    const BicycleState start{poseOf(memberOf(in, "rear_axle")), numberOf(in, "speed"),
                             numberOf(in, "acceleration"), numberOf(in, "steering")};
    const std::vector<Pose2> poses =
        planner.plan(start, agentsOf(in), world.pdmMap(textOf(in, "route")), limit);
    if (memberOf(out, "fragile").GetBool()) continue;
    compareMotions(planner, out);
    compareScores(planner, out);
    EXPECT_EQ(planner.best(), memberOf(out, "chosen").GetUint());
    EXPECT_EQ(planner.isEmergencyBraking(), memberOf(out, "emergency_brake").GetBool());
    const auto expected = memberOf(out, "rear_axle_x_y_heading_every_half_s").GetArray();
    for (rapidjson::SizeType i = 0; i < expected.Size(); ++i) {
      const Pose2& pose = poses.at(5 * i);
      EXPECT_NEAR(pose.x, numberOf(expected[i][0]), kPoseTolerance);
      EXPECT_NEAR(pose.y, numberOf(expected[i][1]), kPoseTolerance);
      EXPECT_NEAR(angleBetween(pose.yaw, numberOf(expected[i][2])), 0.0, kPoseTolerance);
    }
  }
}

/// What is left of the differences when roads and lanes are told from a map as nuScenes has
/// it: the whole planner of the suite on the same worlds.
TEST(PdmClosedParity, OnAMapOfLanesItChoosesTheSameInMostPlans) {
  const ParityFixture fixture("pdm_closed.json");
  const ParityFixture maps("maps.json");
  SKIP_WITHOUT(fixture);
  SKIP_WITHOUT(maps);
  int plans = 0, chosen = 0, brakes = 0;
  for (const rapidjson::Value* value : fixture.cases("plans")) {
    const rapidjson::Value& in = memberOf(*value, "in");
    const rapidjson::Value& out = memberOf(*value, "out");
    if (memberOf(out, "fragile").GetBool()) continue;
    const ParityVehicle vehicle = vehicleOf(fixture, textOf(in, "vehicle"));
    const ParityMap world(maps, textOf(in, "map"));
    const rapidjson::Value& lanes = memberOf(in, "centerline_lanes");
    const PlannerOptions& shipped = shippedConfig().planners;
    PdmPlanner planner(shipped.pdm, shipped.route_centerline, shipped.car, shipped.lqr);
    const PdmPath centerline = world.pathAlong(lanes);
    DrivingTask task{world.laneIndex(), {}, vehicle.ego, vehicle.wheelbase};
    for (double way = 0.0; way < centerline.length(); way += 1.0) {
      task.route.push_back(centerline.at(way).position());
    }
    planner.initialize(task);
    const BicycleState start{poseOf(memberOf(in, "rear_axle")), numberOf(in, "speed"),
                             numberOf(in, "acceleration"), numberOf(in, "steering")};
    KinematicBicycleOptions car = shipped.car;
    car.wheelbase = vehicle.wheelbase;
    planner.plan(
        {KinematicBicycle(car).pointOf(start, 0.0, vehicle.ego.center_offset), agentsOf(in)});
    ++plans;
    chosen += planner.closed()->best() == memberOf(out, "chosen").GetUint();
    brakes += planner.closed()->isEmergencyBraking() == memberOf(out, "emergency_brake").GetBool();
  }
  std::cout << "same choice in " << chosen << ", same brake in " << brakes << " of " << plans
            << " plans\n";
  EXPECT_GE(chosen, 0.8 * plans);
  EXPECT_GE(brakes, 0.95 * plans);
}

/// A lead on the ego's line and nuPlan's loop around the planner.
class Loop {
 public:
  Loop(const ParityFixture& fixture, const ParityFixture& maps, const rapidjson::Value& in)
      : vehicle_(vehicleOf(fixture, textOf(in, "vehicle"))),
        world_(maps, textOf(in, "map")),
        map_(world_.pdmMap(textOf(in, "route"))),
        lanes_(world_.lanesFrom(poseOf(memberOf(in, "rear_axle")), textOf(in, "route"))),
        planner_(plannerIn(vehicle_, world_.pathAlong(lanes_))),
        car_(unboundedCar(vehicle_.wheelbase)),
        tracker_(shippedConfig().planners.lqr, vehicle_.wheelbase),
        state_{poseOf(memberOf(in, "rear_axle")), numberOf(in, "speed"), 0.0, 0.0},
        lead_size_{numberOf(memberOf(in, "lead_size")[0]), numberOf(memberOf(in, "lead_size")[1])},
        lead_speed_(numberOf(in, "lead_speed")) {
    const double ahead = 0.5 * (vehicle_.ego.size.length + lead_size_.length) +
                         vehicle_.ego.center_offset + numberOf(in, "gap");
    lead_ = compose(state_.rear_axle, {ahead, 0.0, 0.0});
  }

  void step() {
    Track lead{"lead", AgentClass::kCar, lead_size_, {}};
    lead.states.push_back({0.0, lead_, lead_speed_ * lead_.heading()});
    const double limit = world_.speedLimit(lanes_.front(), pdmOptions().speed_limit);
    tracker_.setReference(planner_.plan(state_, {lead}, map_, limit));
    const double duration = shippedConfig().planners.lqr.step;
    state_ = car_.step(state_, tracker_.command(state_, 0), duration);
    lead_ = compose(lead_, {lead_speed_ * duration, 0.0, 0.0});
    brakes_ += planner_.isEmergencyBraking();
  }

  double gap() const {
    const Pose2 offset =
        relativeTo(boxMiddleOf(state_.rear_axle, vehicle_.ego.center_offset), lead_);
    return offset.x - 0.5 * (vehicle_.ego.size.length + lead_size_.length);
  }
  double speed() const { return state_.speed; }
  int brakes() const { return brakes_; }

 private:
  static KinematicBicycle unboundedCar(double wheelbase) {
    KinematicBicycleOptions options = shippedConfig().planners.car;
    options.wheelbase = wheelbase;
    options.max_acceleration = options.max_braking = std::numeric_limits<double>::infinity();
    return KinematicBicycle(options);
  }

  ParityVehicle vehicle_;
  ParityMap world_;
  PdmMap map_;
  std::vector<std::string> lanes_;
  PdmClosed planner_;
  KinematicBicycle car_;
  LqrTracker tracker_;
  BicycleState state_;
  BoxSize lead_size_;
  double lead_speed_;
  Pose2 lead_;
  int brakes_ = 0;
};

TEST(PdmClosedParity, DrivesInClosedLoopAsThePublishedOne) {
  const ParityFixture fixture("pdm_closed.json");
  const ParityFixture maps("maps.json");
  SKIP_WITHOUT(fixture);
  SKIP_WITHOUT(maps);
  int number = 0;
  for (const rapidjson::Value* value : fixture.cases("loops")) {
    SCOPED_TRACE("loop " + std::to_string(number++));
    const rapidjson::Value& in = memberOf(*value, "in");
    const rapidjson::Value& out = memberOf(*value, "out");
    Loop loop(fixture, maps, in);
    const auto expected = memberOf(out, "gap_and_speed_every_s").GetArray();
    const int steps = memberOf(in, "steps").GetInt();
    bool is_contact = false;
    for (int step = 1; step <= steps && !is_contact; ++step) {
      loop.step();
      is_contact = loop.gap() <= 0.0;
      const auto second = static_cast<rapidjson::SizeType>(step / 10 - 1);
      if (is_contact || step % 10 != 0 || second >= expected.Size()) continue;
      EXPECT_NEAR(loop.gap(), numberOf(expected[second][0]), 0.02) << "after " << step;
      EXPECT_NEAR(loop.speed(), numberOf(expected[second][1]), 0.05) << "after " << step;
    }
    EXPECT_EQ(is_contact, memberOf(out, "contact").GetBool());
  }
}

}  // namespace
}  // namespace forge
