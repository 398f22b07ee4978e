#include "collision_forge/attack/severity/severity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "attack/search/test_scenes.h"

namespace forge {
namespace {

constexpr double kKmh = 1.0 / 3.6;  // m/s
const BoxSize kBox{4.5, 1.8};

const SeverityOptions& options() {
  static const SeverityOptions shipped = shippedOptions().verification.severity;
  return shipped;
}

CrashedVehicle party(AgentClass agent_class, const BoxSize& size, const Pose2& pose, double speed) {
  return {agent_class, size, {0.0, pose, speed * pose.heading()}};
}

CrashedVehicle car(const Pose2& pose, double speed) {
  return party(AgentClass::kCar, kBox, pose, speed);
}

double logistic(double value) { return 1.0 / (1.0 + std::exp(-value)); }

TEST(Severity, OfARearEndIsByTheSideOfEachCar) {
  const CrashSeverity severity = severityOf(car({4.5, 0, 0}, 5.0), car({0, 0, 0}, 15.0), options());
  const double restitution = 0.1 + 0.4 * std::exp(-0.23 * 10.0);
  EXPECT_NEAR(severity.ego.delta_v, (1.0 + restitution) * 5.0, 1e-9);
  EXPECT_NEAR(severity.other.delta_v, severity.ego.delta_v, 1e-9);
  EXPECT_NEAR(severity.ego.yaw_rate_change, 0.0, 1e-9);
  EXPECT_EQ(clockHour(severity.ego.force_from), 6);
  EXPECT_EQ(clockHour(severity.other.force_from), 12);
  const double speed = severity.ego.delta_v / 0.44704;  // mph
  EXPECT_NEAR(severity.ego.mais3, logistic(-8.0329 + 0.1793 * speed), 1e-12);
  EXPECT_NEAR(severity.other.mais2, logistic(-4.9429 + 0.1425 * speed), 1e-12);
  EXPECT_EQ(severity.ego.curve, "NHTSA DOT HS 813 219, rear");
  EXPECT_EQ(severity.other.curve, "NHTSA DOT HS 813 219, front");
}

TEST(Severity, OfAnOffsetHeadOnTurnsBothCarsTheSameWay) {
  const CrashSeverity severity =
      severityOf(car({0, 0, 0}, 15.0), car({4.5, 0.9, M_PI}, 15.0), options());
  EXPECT_NEAR(severity.ego.delta_v, severity.other.delta_v, 1e-9);
  EXPECT_GT(severity.ego.yaw_rate_change, 0.5) << "left fronts meet: to the left";
  EXPECT_NEAR(severity.ego.yaw_rate_change, severity.other.yaw_rate_change, 1e-9);
}

TEST(Severity, OfASideImpactPointsToTheStruckSide) {
  const CrashSeverity severity =
      severityOf(car({0, 0, 0}, 0.0), car({0, -3.15, M_PI_2}, 15.0), options());
  EXPECT_EQ(clockHour(severity.ego.force_from), 3) << "from the right";
  EXPECT_EQ(clockHour(severity.other.force_from), 12);
  EXPECT_EQ(severity.ego.curve, "NHTSA DOT HS 813 219, side");
  EXPECT_GT(severity.worse().mais3, 0.0);
}

TEST(Severity, AHeavierPartnerMeansMoreDeltaV) {
  const CrashedVehicle truck = party(AgentClass::kTruck, {9.0, 2.5}, {6.75, 0, M_PI}, 10.0);
  const CrashSeverity severity = severityOf(car({0, 0, 0}, 10.0), truck, options());
  EXPECT_GT(severity.ego.delta_v, 15.0);
  EXPECT_LT(severity.other.delta_v, 4.0);
  EXPECT_GT(severity.ego.mais2, severity.ego.mais3);
}

TEST(Severity, OfVulnerablePeopleIsByTheImpactSpeed) {
  const auto hitBy = [](AgentClass person, const BoxSize& size, double speed) {
    const Pose2 place{2.25 + 0.5 * size.width, 0, M_PI_2};
    return severityOf(car({0, 0, 0}, speed * kKmh), party(person, size, place, 0.0), options());
  };
  const CrashSeverity walker = hitBy(AgentClass::kPedestrian, {0.6, 0.7}, 43.0);
  EXPECT_EQ(walker.other.curve, "Monfort and Mueller 2025, pedestrian");
  const double height = 75.0 - 85.25;
  const double faster = 43.0 - 42.79;
  EXPECT_NEAR(walker.other.mais3,
              logistic(-0.46 + 0.091 * faster + 0.039 * height + 0.002 * faster * height), 1e-9);
  EXPECT_LT(walker.ego.mais3, 0.01) << "the car hardly slows down";
  const CrashSeverity cyclist = hitBy(AgentClass::kBicycle, {1.8, 0.6}, 43.0 + 15.0);
  EXPECT_NEAR(cyclist.other.mais3, walker.other.mais3, 1e-9);
  const CrashSeverity rider = hitBy(AgentClass::kMotorcycle, {2.1, 0.8}, 43.0 + 19.0);
  EXPECT_NEAR(rider.other.mais3, walker.other.mais3, 1e-9);
  for (const AgentClass person : {AgentClass::kChild, AgentClass::kRunner, AgentClass::kScooter}) {
    const CrashSeverity hit = hitBy(person, {0.6, 0.7}, 43.0);
    EXPECT_NEAR(hit.other.mais3, walker.other.mais3, 1e-9) << toString(person);
    EXPECT_EQ(hit.other.curve, std::string("Monfort and Mueller 2025, ") + toString(person));
  }
  EXPECT_EQ(severityClass(hitBy(AgentClass::kPedestrian, {0.6, 0.7}, 5.0).other), "S1");
  EXPECT_EQ(severityClass(walker.other), "S2 to S3");
  EXPECT_EQ(severityClass(hitBy(AgentClass::kPedestrian, {0.6, 0.7}, 80.0).other), "S3");
}

TEST(Severity, ClassIsARangeWhereTheBoundsDiffer) {
  const auto rearEnd = [](double closing) {
    const double ego_speed = 5.0;
    return severityOf(car({4.5, 0, 0}, ego_speed), car({0, 0, 0}, ego_speed + closing), options());
  };
  EXPECT_EQ(severityClass(rearEnd(0.5).ego), "S0");
  EXPECT_EQ(severityClass(rearEnd(10.0).ego), "S1 to S2");  // 20.4 km/h
  EXPECT_EQ(severityClass(rearEnd(40.0).ego), "S3");
}

TEST(Severity, ObjectsAndTrailersHaveNoInjuries) {
  for (const AgentClass agent_class : {AgentClass::kStaticObject, AgentClass::kTrailer}) {
    const CrashedVehicle other = party(agent_class, {2.0, 2.0}, {3.25, 0, 0}, 0.0);
    const CrashSeverity severity = severityOf(car({0, 0, 0}, 10.0), other, options());
    EXPECT_EQ(severity.other.mais2, 0.0);
    EXPECT_EQ(severity.other.curve, "");
    EXPECT_GT(severity.ego.delta_v, 0.0);
  }
}

TEST(Severity, ATouchWithoutOverlapHasAnImpactAtTheTouchedCorners) {
  CrashedVehicle slow = car({4.5, 0, 0}, 5.0);
  SeverityOptions immediate = options();
  immediate.engagement = 0.0;
  slow.state.pose.x += 1e-6;
  EXPECT_GT(severityOf(slow, car({0, 0, 0}, 15.0), immediate).ego.delta_v, 5.0);
}

TEST(SeverityOptions, MassesAndInertiasAreThoseOfMeasuredVehicles) {
  const auto body = [](AgentClass agent_class, double length, double width) {
    return bodyOf(party(agent_class, {length, width}, {}, 0.0), options());
  };
  const ImpactBody accord = body(AgentClass::kCar, 4.80, 1.78);  // 1565 kg, 2918 kg m2
  EXPECT_NEAR(accord.mass, 1565.0, 150.0);
  EXPECT_NEAR(accord.yaw_inertia, 2918.0, 300.0);
  EXPECT_NEAR(body(AgentClass::kTruck, 7.0, 2.5).mass, 7500.0, 100.0);
  EXPECT_NEAR(body(AgentClass::kBus, 12.0, 2.55).mass, 13000.0, 100.0);
  EXPECT_EQ(body(AgentClass::kPedestrian, 0.6, 0.7).mass, 75.0);
  EXPECT_LT(body(AgentClass::kChild, 0.5, 0.4).mass, 40.0);
  EXPECT_GE(body(AgentClass::kCar, 1.0, 1.0).mass, 700.0);
}

}  // namespace
}  // namespace forge
