#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "collision_forge/planner_test/planners/pdm_closed.h"
#include "parity/pdm_world.h"
#include "planner_test/planners/planner_scenes.h"

namespace forge {
namespace {

constexpr double kTolerance = 1e-6;

const PdmOptions& pdmOptions() { return shippedConfig().planners.pdm; }

double valueOr(const rapidjson::Value& object, const char* name, double other) {
  return object.HasMember(name) && !object[name].IsNull() ? numberOf(object, name) : other;
}

IdmParameters idmOf(const rapidjson::Value& in, std::size_t policy) {
  const rapidjson::Value& given = memberOf(in, "parameters");
  IdmParameters idm = pdmOptions().idm;
  idm.min_gap = valueOr(given, "min_gap_to_lead_agent", idm.min_gap);
  idm.time_headway = valueOr(given, "headway_time", idm.time_headway);
  idm.max_acceleration = valueOr(given, "accel_max", idm.max_acceleration);
  idm.braking = valueOr(given, "decel_max", idm.braking);
  idm.desired_speed =
      pdmOptions().speed_shares[policy] * valueOr(in, "speed_limit", pdmOptions().speed_limit);
  return idm;
}

TEST(PdmIdmParity, StepsAsThePublishedOne) {
  const ParityFixture fixture("pdm_idm.json");
  SKIP_WITHOUT(fixture);
  for (const rapidjson::Value* value : fixture.cases("steps")) {
    const rapidjson::Value& in = memberOf(*value, "in");
    const rapidjson::Value& out = memberOf(*value, "out");
    const std::vector<double> speeds = numbersOf(memberOf(out, "speed"));
    for (std::size_t policy = 0; policy < speeds.size(); ++policy) {
      const double progress = numberOf(in, "progress");
      const double gap =
          numberOf(in, "lead_progress") - progress - numberOf(in, "lead_length_rear");
      const IdmState next = eulerStep(idmOf(in, policy), {progress, numberOf(in, "speed")},
                                      {gap, numberOf(in, "lead_speed")}, numberOf(in, "dt"));
      EXPECT_NEAR(next.progress, numberOf(out, "progress"), kTolerance);
      EXPECT_NEAR(next.speed, speeds[policy], kTolerance);
    }
  }
}

/// What the fixture says of the lead in its unrolls.
PathLead leadIn(const rapidjson::Value& in, double progress, int step) {
  if (memberOf(in, "gap").IsNull()) return {300.0, 0.0, 2.042};
  const double speed = numberOf(in, "lead_speed");
  const double place = numberOf(in, "gap") + speed * numberOf(in, "dt") * step;
  return {std::max(place, progress), speed, 0.0};
}

TEST(PdmIdmParity, UnrollsAsThePublishedOne) {
  const ParityFixture fixture("pdm_idm.json");
  SKIP_WITHOUT(fixture);
  for (const rapidjson::Value* value : fixture.cases("unrolls")) {
    const rapidjson::Value& in = memberOf(*value, "in");
    const auto expected =
        memberOf(memberOf(*value, "out"), "progress_speed_per_policy_at_steps_1_2_10_40")
            .GetArray();
    for (std::size_t policy = 0; policy < pdmOptions().speed_shares.size(); ++policy) {
      std::vector<IdmState> states = {{0.0, numberOf(in, "speed")}};
      PathLead lead;
      for (int step = 1; step <= 40; ++step) {
        if (step % pdmOptions().lead_interval == 0) lead = leadIn(in, states.back().progress, step);
        const double gap = lead.progress - states.back().progress - lead.rear;
        states.push_back(
            eulerStep(idmOf(in, policy), states.back(), {gap, lead.speed}, numberOf(in, "dt")));
      }
      const std::array<std::size_t, 4> steps = {1, 2, 10, 40};
      for (rapidjson::SizeType i = 0; i < steps.size(); ++i) {
        const auto& state = expected[i][static_cast<rapidjson::SizeType>(policy)];
        EXPECT_NEAR(states[steps[i]].progress, numberOf(state[0]), kTolerance);
        EXPECT_NEAR(states[steps[i]].speed, numberOf(state[1]), kTolerance);
      }
    }
  }
}

TEST(PdmComfortParity, JudgesAsThePublishedOne) {
  const ParityFixture fixture("pdm_comfort.json");
  const ParityFixture driven("pdm_tracker.json");
  SKIP_WITHOUT(fixture);
  SKIP_WITHOUT(driven);
  const auto motions = driven.cases("cases");
  constexpr double kStep = 0.1;
  for (const rapidjson::Value* value : fixture.cases("cases")) {
    const rapidjson::Value& in = memberOf(*value, "in");
    const rapidjson::Value& out = memberOf(*value, "out");
    const rapidjson::Value& motion = *motions.at(memberOf(in, "tracker_case").GetUint());
    EgoSignals signals;
    for (const auto& state :
         memberOf(memberOf(motion, "out"), "x_y_heading_speed_acceleration_steering").GetArray()) {
      signals.yaw.push_back(numberOf(state[2]));
      signals.longitudinal.push_back(numberOf(state[4]));
      signals.lateral.push_back(0.0);
    }
    const rapidjson::Value& sine = memberOf(in, "added_sine");
    if (!sine.IsNull()) {
      const std::string channel = textOf(sine, "channel");
      std::vector<double>& values = channel == "heading"          ? signals.yaw
                                    : channel == "acceleration_x" ? signals.longitudinal
                                                                  : signals.lateral;
      for (std::size_t i = 0; i < values.size(); ++i) {
        const double time = kStep * static_cast<double>(i);
        values[i] +=
            numberOf(sine, "amplitude") * std::sin(2.0 * M_PI * time / numberOf(sine, "period"));
      }
    }
    const PdmComfort comfort(static_cast<int>(signals.yaw.size()), kStep,
                             pdmOptions().scoring.comfort);
    const ComfortRanges ranges = comfort.ranges(signals);
    const auto kept = comfort.keptLimits(ranges);
    const std::array<const char*, 6> names = {"lon_acceleration", "lat_acceleration", "jerk",
                                              "lon_jerk",         "yaw_acceleration", "yaw_rate"};
    for (std::size_t i = 0; i < names.size(); ++i) {
      const rapidjson::Value& range = memberOf(memberOf(out, "signal_min_max"), names[i]);
      EXPECT_NEAR(ranges[i].low, numberOf(range[0]), 2e-6) << names[i];
      EXPECT_NEAR(ranges[i].high, numberOf(range[1]), 2e-6) << names[i];
      EXPECT_EQ(kept[i], memberOf(memberOf(out, "within_bounds"), names[i]).GetBool()) << names[i];
    }
    const bool is_comfortable =
        std::all_of(kept.begin(), kept.end(), [](bool is_kept) { return is_kept; });
    EXPECT_EQ(is_comfortable, memberOf(out, "comfortable").GetBool());
  }
}

std::optional<double> finite(double value) {
  return std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
}

TEST(PdmEmergencyBrakeParity, FiresAndLaysOutAsThePublishedOne) {
  const ParityFixture fixture("pdm_emergency_brake.json");
  SKIP_WITHOUT(fixture);
  const PdmBrakeOptions& options = pdmOptions().emergency_brake;
  for (const rapidjson::Value* value : fixture.cases("cases")) {
    const rapidjson::Value& in = memberOf(*value, "in");
    const rapidjson::Value& out = memberOf(*value, "out");
    const ParityVehicle vehicle = vehicleOf(fixture, textOf(in, "vehicle"));
    KinematicBicycleOptions car = shippedConfig().planners.car;
    car.wheelbase = vehicle.wheelbase;
    const BicycleState state{poseOf(memberOf(in, "rear_axle")), numberOf(in, "speed"),
                             numberOf(in, "acceleration"), numberOf(in, "steering")};
    const std::vector<double> scores = numbersOf(memberOf(in, "scores_of_two_proposals"));
    const std::vector<double> times =
        numbersOf(memberOf(in, "time_to_infraction_of_two_proposals"));
    const auto best =
        static_cast<std::size_t>(std::max_element(scores.begin(), scores.end()) - scores.begin());
    EXPECT_EQ(firesBrake(state.speed, finite(times[best]), options),
              memberOf(out, "fires").GetBool());
    const double offset = vehicle.ego.center_offset;
    const double acceleration =
        centerAcceleration(state, KinematicBicycle(car).curvature(state), offset);
    EXPECT_NEAR(acceleration, numberOf(out, "center_acceleration_x"), 1e-5);
    const double speed = brakeSpeed(state.speed, acceleration, options);
    EXPECT_NEAR(speed, numberOf(out, "laid_out_speed"), 1e-5);
    const std::vector<Pose2> poses = brakePoses(state.rear_axle, speed, 80, 0.1);
    const auto expected = memberOf(out, "center_x_y_heading_at_0_1_8_s").GetArray();
    const std::array<std::size_t, 3> steps = {0, 10, 80};
    for (rapidjson::SizeType i = 0; i < steps.size(); ++i) {
      const Pose2 middle = boxMiddleOf(poses[steps[i]], offset);
      EXPECT_NEAR(middle.x, numberOf(expected[i][0]), kTolerance);
      EXPECT_NEAR(middle.y, numberOf(expected[i][1]), kTolerance);
      EXPECT_NEAR(angleBetween(middle.yaw, numberOf(expected[i][2])), 0.0, kTolerance);
    }
  }
}

std::vector<Track> agentsOf(const rapidjson::Value& in) {
  std::vector<Track> agents;
  for (const auto& agent : memberOf(in, "agents").GetArray()) agents.push_back(agentOf(agent, 0.0));
  return agents;
}

std::set<std::string> namesOf(const rapidjson::Value& list) {
  std::set<std::string> names;
  for (const auto& name : list.GetArray()) names.insert(name.GetString());
  return names;
}

PdmMotion motionOf(const rapidjson::Value& states, const EgoVehicle& ego) {
  std::vector<BicycleState> motion;
  for (const auto& state : states.GetArray()) {
    motion.push_back({poseOf(state), numberOf(state[3]), numberOf(state[4]), 0.0});
  }
  return motionOf(std::move(motion), ego);
}

/// The places of a motion with each flag set, as the fixture counts them.
std::array<int, 3> flagsOf(const PdmMotion& motion, const PdmMap& map) {
  std::array<int, 3> count{};
  for (const OrientedBox& box : motion.boxes) {
    const PdmPlace place = map.placeOf(box);
    count[0] += place.is_in_several_lanes;
    count[1] += place.is_off_road;
    count[2] += place.is_wrong_way;
  }
  return count;
}

class ScoreParity {
 public:
  ScoreParity(const rapidjson::Value& out, std::size_t proposal)
      : out_(out), index_(static_cast<rapidjson::SizeType>(proposal)) {
    for (const auto& entry : memberOf(out, "fragile_proposals").GetArray()) {
      is_fragile_ = is_fragile_ || entry.GetUint() == proposal;
    }
  }
  bool isFragile() const { return is_fragile_; }

  void compare(const PdmScore& score) const {
    const double kNever = HUGE_VAL;
    expect("no_at_fault_collision", score.collision);
    expect("drivable_area", score.drivable_area);
    expect("driving_direction", score.driving_direction);
    expect("progress_raw", score.driven);
    expect("progress", score.progress);
    expect("ttc", score.time_to_collision);
    expect("comfort", score.comfort);
    expect("time_to_at_fault_collision", score.collision_time.value_or(kNever));
    expect("time_to_ttc_infraction", score.ttc_time.value_or(kNever));
    expect("score", score.total);
  }

 private:
  void expect(const char* name, double value) const {
    const double expected = numberOf(memberOf(out_, name)[index_]);
    if (std::isinf(expected) || std::isinf(value)) {
      EXPECT_EQ(value, expected) << name << " of proposal " << index_;
    } else {
      EXPECT_NEAR(value, expected, 2e-6) << name << " of proposal " << index_;
    }
  }

  const rapidjson::Value& out_;
  rapidjson::SizeType index_;
  bool is_fragile_ = false;
};

TEST(PdmScorerParity, ScoresAsThePublishedOne) {
  const ParityFixture fixture("pdm_scorer.json");
  const ParityFixture maps("maps.json");
  SKIP_WITHOUT(fixture);
  SKIP_WITHOUT(maps);
  const PdmOptions& options = pdmOptions();
  const PdmComfort comfort(options.proposal_steps + 1, options.step, options.scoring.comfort);
  int number = 0;
  for (const rapidjson::Value* value : fixture.cases("cases")) {
    SCOPED_TRACE("case " + std::to_string(number++));
    const rapidjson::Value& in = memberOf(*value, "in");
    const rapidjson::Value& out = memberOf(*value, "out");
    const EgoVehicle ego = vehicleOf(fixture, textOf(in, "vehicle")).ego;
    const ParityMap world(maps, textOf(in, "map"));
    const PdmMap map = world.pdmMap(textOf(in, "route"));
    const PdmPath centerline = world.pathAlong(memberOf(in, "centerline_lanes"));
    const OrientedBox box{boxMiddleOf(poseOf(memberOf(in, "rear_axle")), ego.center_offset),
                          ego.size};
    std::set<std::string> ignored;
    const PdmForecast forecast(agentsOf(in), box, options.step, 50, options.agents, ignored);
    EXPECT_EQ(ignored, namesOf(memberOf(out, "ignored_at_start")));
    std::vector<PdmMotion> motions;
    for (const auto& states : memberOf(in, "proposals_x_y_heading_speed_acceleration").GetArray()) {
      motions.push_back(motionOf(states, ego));
    }
    const PdmScorer scorer({forecast, map, centerline, comfort}, options.scoring);
    const std::vector<PdmScore> scores = scorer.score(motions);
    for (std::size_t i = 0; i < scores.size(); ++i) {
      const ScoreParity expected(out, i);
      if (expected.isFragile()) continue;
      expected.compare(scores[i]);
      const auto& flags = memberOf(
          out, "steps_in_multiple_lanes_off_road_oncoming")[static_cast<rapidjson::SizeType>(i)];
      const std::array<int, 3> count = flagsOf(motions[i], map);
      for (rapidjson::SizeType flag = 0; flag < count.size(); ++flag) {
        EXPECT_EQ(count[flag], flags[flag].GetInt()) << "flag " << flag << " of proposal " << i;
      }
    }
  }
}

}  // namespace
}  // namespace forge
