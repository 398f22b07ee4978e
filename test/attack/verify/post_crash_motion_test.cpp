#include "collision_forge/attack/verify/post_crash_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "attack/search/test_scenes.h"
#include "collision_forge/planner_test/settings/config.h"

namespace forge {
namespace {

constexpr double kContact = 10.0;  // s

const SeverityOptions& options() {
  static const Config config = loadConfig(COLLISION_FORGE_SOURCE_DIR "/config");
  return config.attack.verification.severity;
}

CrashedVehicle party(AgentClass agent_class, const BoxSize& size, const Pose2& pose,
                     const Vector2& velocity) {
  return {agent_class, size, {kContact, pose, velocity}};
}

CrashedVehicle car(const Pose2& pose, const Vector2& velocity) {
  return party(AgentClass::kCar, kCarSize, pose, velocity);
}

double depth(const PostCrashMotion& motion, double time) {
  const auto gaps = axisGaps({motion.egoAt(time).pose, motion.egoSize()},
                             {motion.attackerAt(time).pose, motion.attackerSize()});
  return -std::max_element(gaps.begin(), gaps.end(), [](const AxisGap& a, const AxisGap& b) {
            return a.gap < b.gap;
          })->gap;
}

double energy(const AgentState& state, const CrashedVehicle& of) {
  return 0.5 * bodyOf(of, options()).mass * state.velocity.squaredNorm();
}

/// The attacker hits the left side of the ego 1.5 m behind its centre.
struct SideImpact {
  CrashedVehicle ego = car({0.0, 0.0, 0.0}, {12.0, 0.0});
  CrashedVehicle attacker =
      car({-1.5, 0.5 * (kCarSize.width + kCarSize.length), -M_PI / 2}, {0.0, -9.0});
};

CrashedVehicle mirrored(CrashedVehicle vehicle) {
  vehicle.state.pose.y *= -1.0;
  vehicle.state.pose.yaw *= -1.0;
  vehicle.state.velocity.y() *= -1.0;
  return vehicle;
}

TEST(PostCrashMotion, BeginsWithTheImpactAfterTheEngagement) {
  const SideImpact crash;
  const PostCrashMotion motion(crash.ego, crash.attacker, options());
  EXPECT_EQ(motion.contactTime(), kContact);
  EXPECT_EQ(motion.egoAt(9.0).pose.x, 0.0) << "before the contact as at the contact";
  const Impact impact = impactOf(crash.ego, crash.attacker, options());
  const double engaged = kContact + options().engagement;
  EXPECT_NEAR(motion.egoAt(engaged).pose.x, 12.0 * options().engagement, 1e-9);
  EXPECT_NEAR((motion.egoAt(engaged).velocity - Vector2(12.0, 0.0) - impact.first.velocity).norm(),
              0.0, 1e-9);
  EXPECT_NEAR(
      (motion.attackerAt(engaged).velocity - Vector2(0.0, -9.0) - impact.second.velocity).norm(),
      0.0, 1e-9);
}

TEST(PostCrashMotion, AnImpactBehindTheCentreTurnsTheEgo) {
  const SideImpact crash;
  const PostCrashMotion motion(crash.ego, crash.attacker, options());
  EXPECT_GT(motion.egoAt(kContact + 0.5).pose.yaw, 0.5) << "its rear goes to the right";
  const AgentState end = motion.egoAt(motion.standTime());
  EXPECT_LT(end.pose.y, -0.5) << "pushed to the right";
  EXPECT_GT(end.pose.x, 3.0);
  EXPECT_EQ(end.velocity.norm(), 0.0);
  EXPECT_EQ(motion.egoAt(60.0).pose.x, end.pose.x);
}

TEST(PostCrashMotion, AMirroredCrashMovesMirrored) {
  const SideImpact crash;
  const PostCrashMotion motion(crash.ego, crash.attacker, options());
  const PostCrashMotion other(mirrored(crash.ego), mirrored(crash.attacker), options());
  EXPECT_NEAR(other.standTime(), motion.standTime(), 1e-9);
  for (const double time : {10.02, 10.3, 11.0, 12.0, 15.0}) {
    const AgentState there = mirrored({{}, {}, motion.egoAt(time)}).state;
    const AgentState here = other.egoAt(time);
    EXPECT_NEAR((here.pose.position() - there.pose.position()).norm(), 0.0, 1e-6) << time;
    EXPECT_NEAR(here.pose.yaw, there.pose.yaw, 1e-6) << time;
  }
}

TEST(PostCrashMotion, LosesEnergyAndNeverDeepensTheOverlap) {
  const SideImpact side;
  const double end_to_end = kCarSize.length;
  const std::vector<std::pair<CrashedVehicle, CrashedVehicle>> crashes = {
      {side.ego, side.attacker},
      {car({}, {5.0, 0.0}), car({-end_to_end, 0.3, 0.0}, {15.0, 0.0})},
      {car({}, {15.0, 0.0}), car({end_to_end, 0.5, M_PI}, {-15.0, 0.0})},
      {car({}, {0.0, 0.0}),
       party(AgentClass::kBus, {12.0, 2.5}, {0.5 * (12.0 + end_to_end), 1.0, M_PI}, {-10.0, 0.0})},
      {car({}, {10.0, 0.0}), party(AgentClass::kPedestrian, {0.6, 0.6},
                                   {0.5 * (0.6 + end_to_end), 0.4, M_PI / 2}, {0.0, 1.4})}};
  for (const auto& [ego, attacker] : crashes) {
    const PostCrashMotion motion(ego, attacker, options());
    const double engaged = kContact + options().engagement + 1e-6;
    const double deepest = depth(motion, engaged);
    double last = energy(ego.state, ego) + energy(attacker.state, attacker);
    for (double time = engaged; time < motion.standTime(); time += 0.05) {
      EXPECT_LT(depth(motion, time), deepest + 0.1) << toString(attacker.agent_class) << time;
      const double now =
          energy(motion.egoAt(time), ego) + energy(motion.attackerAt(time), attacker);
      EXPECT_LT(now, last * 1.02) << toString(attacker.agent_class) << time;
      last = now;
    }
    EXPECT_LT(motion.standTime(), kContact + 12.0) << toString(attacker.agent_class);
  }
}

TEST(PostCrashMotion, AfterALightTouchTheDriversBrakeAfterTheirDelay) {
  const double speed = 15.0;
  const PostCrashMotion motion(car({}, {speed, 0.0}),
                               car({-kCarSize.length, 0.0, 0.0}, {speed + 1.0, 0.0}), options());
  const AfterImpactOptions& after = options().after_impact;
  const double rolled = motion.egoAt(kContact + after.braking_delay).velocity.x();
  EXPECT_GT(rolled, speed - 2.0 * 9.81 * after.rolling_drag * after.braking_delay);
  EXPECT_NEAR(motion.standTime(),
              kContact + after.braking_delay + rolled / (after.braking + 9.81 * after.rolling_drag),
              0.3);
}

TEST(SecondaryContacts, NamesTheAgentsThatAreTouchedByTheirFirstTouch) {
  const SideImpact crash;
  const PostCrashMotion motion(crash.ego, crash.attacker, options());
  const AgentState end = motion.egoAt(motion.standTime());
  const auto standing = [](const char* id, double x, double y) {
    Track track{id, AgentClass::kCar, {2.0, 2.0}, {}};
    for (int time = 0; time <= 60; ++time) track.states.push_back({1.0 * time, {x, y, 0.0}});
    return track;
  };
  const auto contacts = secondaryContacts(
      motion, "attacker",
      {standing("far", 100.0, 0.0), standing("met", end.pose.x, end.pose.y),
       standing("attacker", end.pose.x, end.pose.y), standing("overlaps", -1.0, 0.0)});
  ASSERT_FALSE(contacts.empty());
  EXPECT_EQ(contacts.front().agent_id, "met");
  EXPECT_TRUE(contacts.front().is_ego);
  EXPECT_GT(contacts.front().time, kContact);
  EXPECT_LT(contacts.front().time, motion.standTime());
  for (const SecondaryContact& contact : contacts) {
    EXPECT_TRUE(contact.agent_id == "met" || !contact.is_ego) << contact.agent_id;
  }
}

/// From kNow on for two seconds along +y.
AttackerTrajectory straight() {
  AttackerTrajectory trajectory{"attacker", AgentClass::kCar, kCarSize, {}};
  for (int i = 0; i <= 20; ++i) {
    trajectory.points.push_back({kNow + 0.1 * i, {0.0, 0.6 * i, M_PI / 2}, 6.0, 0.0, 0.0});
  }
  return trajectory;
}

/// Along +x at 10 m/s, over the same time.
Track drivingEgo() {
  Track ego{kEgoId, AgentClass::kCar, kCarSize, {}};
  for (int i = 0; i <= 4; ++i) {
    ego.states.push_back({kNow + 0.5 * i, {5.0 * i, 0.0, 0.0}, {10.0, 0.0}});
  }
  return ego;
}

TEST(MotionAfterContact, BeginsWithTheStatesOfTrajectoryAndEgo) {
  const auto motion = motionAfterContact(kNow + 1.25, straight(), drivingEgo(), options());
  ASSERT_TRUE(motion);
  EXPECT_EQ(motion->contactTime(), kNow + 1.25);
  EXPECT_NEAR(motion->egoAt(kNow + 1.25).pose.x, 12.5, 1e-9);
  EXPECT_NEAR(motion->attackerAt(kNow + 1.25).pose.y, 7.5, 1e-9);
}

TEST(MotionAfterContact, ATimeRoundedBeyondTheEndIsTheEnd) {
  EXPECT_TRUE(motionAfterContact(kNow + 2.0 + 4e-7, straight(), drivingEgo(), options()));
}

TEST(MotionAfterContact, IsEmptyWithoutAContactOrWithoutAnEgoState) {
  EXPECT_FALSE(motionAfterContact(kNow + 2.5, straight(), drivingEgo(), options()));
  EXPECT_FALSE(motionAfterContact(kNow + 1.0, straight(), {}, options()));
  CollisionReport report;
  report.contact_time = kNow + 1.0;
  EXPECT_FALSE(motionAfterContact(report, straight(), drivingEgo(), options()));
  report.contact = true;
  EXPECT_TRUE(motionAfterContact(report, straight(), drivingEgo(), options()));
}

}  // namespace
}  // namespace forge
