#include <limits>

#include "collision_forge/planner_test/planners/lqr_tracker.h"
#include "parity/parity_fixture.h"
#include "planner_test/planners/planner_scenes.h"

namespace forge {
namespace {

constexpr double kTolerance = 2e-6;

BicycleState stateOf(const rapidjson::Value& value) {
  return {poseOf(value), numberOf(value[3]), numberOf(value[4]), numberOf(value[5])};
}

void expectNear(const BicycleState& state, const rapidjson::Value& expected) {
  EXPECT_NEAR(state.rear_axle.x, numberOf(expected[0]), kTolerance);
  EXPECT_NEAR(state.rear_axle.y, numberOf(expected[1]), kTolerance);
  EXPECT_NEAR(angleBetween(numberOf(expected[2]), state.rear_axle.yaw), 0.0, kTolerance);
  EXPECT_NEAR(state.speed, numberOf(expected[3]), kTolerance);
  EXPECT_NEAR(state.acceleration, numberOf(expected[4]), kTolerance);
  EXPECT_NEAR(state.steering, numberOf(expected[5]), kTolerance);
}

void expectNear(const std::vector<double>& values, const rapidjson::Value& expected) {
  ASSERT_EQ(values.size(), expected.Size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_NEAR(values[i], numberOf(expected[static_cast<rapidjson::SizeType>(i)]), kTolerance);
  }
}

/// nuPlan's car, that has no limits but of its wheel.
KinematicBicycle bicycleOf(double wheelbase) {
  KinematicBicycleOptions options = shippedConfig().planners.car;
  options.wheelbase = wheelbase;
  options.max_acceleration = options.max_braking = std::numeric_limits<double>::infinity();
  return KinematicBicycle(options);
}

TEST(PdmTrackerParity, DrivesAsThePublishedOne) {
  const ParityFixture fixture("pdm_tracker.json");
  SKIP_WITHOUT(fixture);
  const LqrOptions& options = shippedConfig().planners.lqr;
  for (const rapidjson::Value* value : fixture.cases("cases")) {
    const rapidjson::Value& in = memberOf(*value, "in");
    const rapidjson::Value& out = memberOf(*value, "out");
    std::vector<Pose2> reference;
    for (const auto& pose : memberOf(in, "reference_x_y_heading").GetArray()) {
      reference.push_back(poseOf(pose));
    }
    const KinematicBicycle bicycle = bicycleOf(numberOf(in, "bicycle_wheel_base"));
    LqrTracker tracker(options, numberOf(in, "tracker_wheel_base"), SpeedFit::kAcceleration);
    tracker.setReference(reference);
    if (out.HasMember("velocity_profile")) {
      expectNear(tracker.profile().speeds, memberOf(out, "velocity_profile"));
      expectNear(tracker.profile().curvatures, memberOf(out, "curvature_profile"));
    }
    BicycleState state = stateOf(memberOf(in, "start_x_y_heading_speed_acceleration_steering"));
    const auto states = memberOf(out, "x_y_heading_speed_acceleration_steering").GetArray();
    for (std::size_t i = 0; i < states.Size(); ++i) {
      expectNear(state, states[static_cast<rapidjson::SizeType>(i)]);
      state = bicycle.step(state, tracker.command(state, i), options.step);
    }
  }
}

}  // namespace
}  // namespace forge
