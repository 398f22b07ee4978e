#include "collision_forge/attack/verify/measured_conditions.h"

#include <gtest/gtest.h>

#include <cmath>

#include "attack/search/test_scenes.h"

namespace forge {
namespace {

/// An ego at 10 m/s along x from the origin, an attacker that is driven by hand, and their contact
/// after 4 s.
class MeasuredConditionsTest : public testing::Test {
 protected:
  static constexpr double kContact = 4.0;

  /// Drives the attacker from a pose, at `speed` and from `brakes` (s) on with `braking` (m/s2).
  ContactConditions measure(const Pose2& start, double speed, double braking, double brakes,
                            Side attacker_side) const {
    AttackerTrajectory trajectory{"attacker", AgentClass::kCar, kCarSize, {}};
    for (int i = 0; i <= 60; ++i) {
      const double time = 0.1 * i;
      const double braked = std::max(0.0, time - brakes);
      const double along = speed * time - 0.5 * braking * braked * braked;
      trajectory.points.push_back({kNow + time, compose(start, {along, 0.0, 0.0}),
                                   speed - braking * braked, braked > 0.0 ? -braking : 0.0, 0.0});
    }
    const Track ego = futureTrack(kEgoId, kEgoSize, {}, 10.0);
    CollisionReport report;
    report.contact_time = kNow + kContact;
    report.ego_at_contact = stateAt(ego, report.contact_time)->pose;
    report.attacker_at_contact = poseAt(trajectory, report.contact_time);
    report.relative_heading =
        angleBetween(report.ego_at_contact.yaw, report.attacker_at_contact.yaw);
    report.attacker_side = attacker_side;
    return measuredConditions(trajectory, report, {ego, {}, {}});
  }
};

TEST_F(MeasuredConditionsTest, OfALeaderThatBrakes) {
  const ContactConditions measured = measure({25.0, 0.3, 0.0}, 10.0, 3.0, 1.0, Side::kRear);
  EXPECT_NEAR(measured.attacker_speed, 10.0 - 3.0 * 3.0, 1e-9);
  EXPECT_NEAR(measured.deceleration, 3.0, 1e-9);
  const double gap = std::hypot(25.0, 0.3) - 0.5 * (kEgoSize.length + kCarSize.length);
  EXPECT_NEAR(measured.gap, gap, 1e-9);
  EXPECT_NEAR(measured.headway, gap / 10.0, 1e-9) << "the ego is behind";
  EXPECT_EQ(measured.lateral_speed, 0.0);
  EXPECT_NEAR(measured.impact_location, 0.5 - 0.3 / kEgoSize.width, 1e-9) << "left of the middle";
  EXPECT_EQ(measured.from_side, Side::kLeft);
}

TEST_F(MeasuredConditionsTest, OfAFollowerTheHeadwayIsItsOwn) {
  const ContactConditions measured = measure({-25.0, 0.0, 0.0}, 15.0, 0.0, 9.0, Side::kFront);
  EXPECT_NEAR(measured.headway, measured.gap / 15.0, 1e-9);
  EXPECT_EQ(measured.deceleration, 0.0);
}

TEST_F(MeasuredConditionsTest, OfACrossingFromTheRight) {
  const ContactConditions measured = measure({43.0, -20.0, M_PI_2}, 5.0, 0.0, 9.0, Side::kLeft);
  EXPECT_NEAR(measured.lateral_speed, 5.0, 1e-9);
  EXPECT_EQ(measured.from_side, Side::kRight);
  EXPECT_NEAR(measured.impact_location, 0.5, 1e-9) << "the middle of its flank is ahead of the ego";
}

TEST_F(MeasuredConditionsTest, TheDepartureIsTheLastSampleAtAStandstill) {
  const auto departure = [&](double waits) {
    return measure({30.0, 0.0, 0.0}, 0.0, -1.0, waits, Side::kRear).departure_time;
  };
  EXPECT_NEAR(departure(1.5), 1.5, 1e-9);
  EXPECT_NEAR(departure(0.0), 0.0, 1e-9);
  EXPECT_EQ(departure(9.0), kNoDeparture) << "stands at the contact";
  EXPECT_EQ(measure({25.0, 0.0, 0.0}, 5.0, 2.0, 0.0, Side::kRear).departure_time, kNoDeparture)
      << "moves at t0";
}

TEST_F(MeasuredConditionsTest, OverlappingBoxesHaveNoGap) {
  EXPECT_EQ(measure({0.0, 2.5, 0.0}, 10.0, 0.0, 9.0, Side::kRight).gap, 0.0);
}

}  // namespace
}  // namespace forge
