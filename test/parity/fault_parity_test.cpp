#include <gtest/gtest.h>

#include <map>

#include "collision_forge/planner_test/trials/contact_judgement.h"
#include "parity/parity_fixture.h"
#include "planner_test/planners/planner_scenes.h"

namespace forge {
namespace {

using rapidjson::Value;

constexpr double kTolerance = 1e-6;

const char* publishedName(ContactCause cause) {
  static const std::map<ContactCause, const char*> names = {
      {ContactCause::kStoppedEgo, "STOPPED_EGO_COLLISION"},
      {ContactCause::kStoppedOther, "STOPPED_TRACK_COLLISION"},
      {ContactCause::kRear, "ACTIVE_REAR_COLLISION"},
      {ContactCause::kFront, "ACTIVE_FRONT_COLLISION"},
      {ContactCause::kLateral, "ACTIVE_LATERAL_COLLISION"}};
  return names.at(cause);
}

/// One collision of the fixture.
struct Collision {
  double center_offset = 0.0;
  ContactSide ego;
  ContactSide other;
};

Collision collisionOf(const ParityFixture& fixture, const Value& in) {
  const EgoVehicle vehicle = vehicleOf(fixture, textOf(in, "vehicle")).ego;
  const Pose2 middle =
      compose(poseOf(memberOf(in, "rear_axle")), {vehicle.center_offset, 0.0, 0.0});
  const Track other = agentOf(memberOf(in, "other"), 0.0);
  const AgentState& state = other.states.back();
  return {
      vehicle.center_offset,
      {{middle, vehicle.size}, numberOf(in, "speed") * middle.heading()},
      {boxAt(other, state.pose), state.velocity, other.agent_class == AgentClass::kStaticObject}};
}

/// The published rule asks whether the front edge meets the other, without a tolerance.
FaultOptions options() {
  FaultOptions options = shippedConfig().planners.rollout.fault;
  options.front_tolerance = 0.0;
  return options;
}

TEST(FaultParity, CollisionTypesAreNuPlans) {
  const ParityFixture fixture("fault.json");
  SKIP_WITHOUT(fixture);
  for (const Value* one : fixture.cases("cases")) {
    const Value& out = memberOf(*one, "out");
    const Collision collision = collisionOf(fixture, memberOf(*one, "in"));
    const auto& [offset, ego, other] = collision;
    EXPECT_NEAR(angleToOther(ego.box, offset, other.box), numberOf(out, "angle"), kTolerance);
    EXPECT_EQ(publishedName(causeOf(ego, offset, other, options())), textOf(out, "type"));
    EXPECT_EQ(overlaps(ego.box, other.box), memberOf(out, "collision").GetBool());
    EXPECT_NEAR(distance(ego.box, other.box), numberOf(out, "gap"), kTolerance);
    // There the other drives along its heading.
    ContactSide driving = other;
    driving.velocity = other.velocity.norm() * other.box.center.heading();
    EXPECT_NEAR(0.5 * impactSpeed(ego, driving), numberOf(out, "ego_delta_v"), kTolerance);
  }
}

TEST(FaultParity, BlamesAsNuPlan) {
  const ParityFixture fixture("fault.json");
  SKIP_WITHOUT(fixture);
  for (const Value* one : fixture.cases("cases")) {
    const Value& out = memberOf(*one, "out");
    const auto& [offset, ego, other] = collisionOf(fixture, memberOf(*one, "in"));
    const ContactCause cause = causeOf(ego, offset, other, options());
    const bool collide = overlaps(ego.box, other.box);
    EXPECT_EQ(collide && isAtFault(cause, true), memberOf(out, "at_fault_one_lane").GetBool());
    EXPECT_EQ(collide && isAtFault(cause, false), memberOf(out, "at_fault_elsewhere").GetBool());
  }
}

}  // namespace
}  // namespace forge
