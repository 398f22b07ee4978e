#include "collision_forge/attack/severity/sliding_body.h"

#include <gtest/gtest.h>

#include <cmath>

#include "collision_forge/planner_test/settings/config.h"

namespace forge {
namespace {

constexpr double kGravity = 9.81;
constexpr double kStep = 0.01;  // s

const SeverityOptions& options() {
  static const Config config = loadConfig(COLLISION_FORGE_SOURCE_DIR "/config");
  return config.attack.verification.severity;
}

CrashedVehicle moving(AgentClass agent_class, const Vector2& velocity, double yaw = 0.0) {
  return {agent_class, {4.6, 1.9}, {0.0, {0.0, 0.0, yaw}, velocity}};
}

/// Moves until the body stands; returns the time, s.
double slide(SlidingBody& body, bool is_braking) {
  double time = 0.0;
  for (; !body.stands() && time < 60.0; time += kStep) body.move(kStep, is_braking);
  return time;
}

TEST(SlidingBody, APersonSlidesByTheFrictionOfTheGround) {
  SlidingBody person(moving(AgentClass::kPedestrian, {6.0, 8.0}), options());
  slide(person, false);
  const double distance = 100.0 / (2.0 * options().after_impact.ground_friction * kGravity);
  EXPECT_NEAR(person.pose().position().norm(), distance, 0.03 * distance);
  EXPECT_NEAR(person.pose().y / person.pose().x, 8.0 / 6.0, 1e-6);
}

TEST(SlidingBody, AVehicleRollsUntilItsDriverBrakes) {
  const AfterImpactOptions& after = options().after_impact;
  SlidingBody car(moving(AgentClass::kCar, {10.0, 0.0}), options());
  for (int i = 0; i < 100; ++i) car.move(kStep, false);
  EXPECT_NEAR(car.body().velocity.x(), 10.0 - after.rolling_drag * kGravity, 0.02);
  const double speed = car.body().velocity.x();
  EXPECT_NEAR(slide(car, true), speed / (after.braking + after.rolling_drag * kGravity), 0.1);
}

TEST(SlidingBody, ACarThatMovesSidewaysSlides) {
  SlidingBody car(moving(AgentClass::kCar, {0.0, 10.0}), options());
  slide(car, false);
  const double distance = 100.0 / (2.0 * options().after_impact.tyre_friction * kGravity);
  EXPECT_NEAR(car.pose().y, distance, 0.03 * distance);
}

TEST(SlidingBody, AHardImpactLocksTheWheelsOfTheStruckEnd) {
  const double hard = options().after_impact.locking_delta_v;
  const auto distanceAfter = [](double change) {
    SlidingBody car(moving(AgentClass::kCar, {10.0 + change, 0.0}), options());
    car.hit({{-change, 0.0}, 0.0}, {2.0, 0.0});
    EXPECT_NEAR(car.body().velocity.x(), 10.0, 1e-9);
    slide(car, false);
    return car.pose().x;
  };
  EXPECT_GT(distanceAfter(0.9 * hard), 1.5 * distanceAfter(1.1 * hard));
}

/// Friction slows a spin on the spot by mu g R m / I, with R the distance of the wheels.
TEST(SlidingBody, ASpinDecaysByTheFrictionOfAllWheels) {
  SlidingBody object(moving(AgentClass::kStaticObject, {0.0, 0.0}), options());
  object.hit({{0.0, 0.0}, 3.0}, {0.0, 0.0});
  for (int i = 0; i < 20; ++i) object.move(kStep, false);
  const ImpactBody& body = object.body();
  const double reach = std::hypot(0.29 * 4.6, 0.4 * 1.9);
  const double decay =
      options().after_impact.ground_friction * kGravity * reach * body.mass / body.yaw_inertia;
  EXPECT_NEAR(body.yaw_rate, 3.0 - 0.2 * decay, 0.02);
  EXPECT_NEAR(body.velocity.norm(), 0.0, 1e-9);
}

}  // namespace
}  // namespace forge
