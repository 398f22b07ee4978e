// Impact of two rigid bodies, and severity of a contact of two boxes.
#include <gtest/gtest.h>

#include <cmath>

#include "collision_forge/attack/severity/severity.h"
#include "collision_forge/base/geometry/swept_contact.h"
#include "properties/random_cases.h"
#include "properties/random_scenes.h"

namespace forge {
namespace {

double cross(const Vector2& a, const Vector2& b) { return a.x() * b.y() - a.y() * b.x(); }

Vector2 within(Random& random, double reach) {
  return {random.uniform(-reach, reach), random.uniform(-reach, reach)};
}

ImpactBody anyBody(Random& random) {
  const double mass = random.uniform(50.0, 30000.0);
  return {mass, mass * random.uniform(0.05, 20.0), within(random, 8.0), within(random, 40.0),
          random.uniform(-2.0, 2.0)};
}

ImpactContact anyContact(Random& random) {
  const double angle = random.uniform(-M_PI, M_PI);
  return {within(random, 8.0),
          {std::cos(angle), std::sin(angle)},
          random.uniform(0.0, 1.0),
          random.uniform(0.0, 2.0)};
}

/// Returns the kinetic energy, J.
double energyOf(const ImpactBody& body, const ImpactChange& change = {}) {
  const double yaw_rate = body.yaw_rate + change.yaw_rate;
  return 0.5 * body.mass * (body.velocity + change.velocity).squaredNorm() +
         0.5 * body.yaw_inertia * yaw_rate * yaw_rate;
}

TEST(Impacts, KeepMomentumAndNeverAddEnergy) {
  constexpr double kRounding = 1e-9;  // share of the largest term
  forAllCases([](Random& random) {
    const ImpactBody first = anyBody(random);
    const ImpactBody second = anyBody(random);
    const ImpactContact contact = anyContact(random);
    const Impact impact = planarImpact(first, second, contact);
    const double impulse = impact.impulse.norm();
    const Vector2 sum = first.mass * impact.first.velocity + second.mass * impact.second.velocity;
    EXPECT_LE(sum.norm(), kRounding * (1.0 + impulse));
    const auto angular = [&](const ImpactBody& body, const ImpactChange& change) {
      return body.yaw_inertia * change.yaw_rate + cross(body.center, body.mass * change.velocity);
    };
    EXPECT_NEAR(angular(first, impact.first) + angular(second, impact.second), 0.0,
                kRounding * (1.0 + 20.0 * impulse));
    const double before = energyOf(first) + energyOf(second);
    const double after = energyOf(first, impact.first) + energyOf(second, impact.second);
    EXPECT_LE(after, before * (1.0 + kRounding));
    EXPECT_NEAR(before - after, impact.energy_lost, kRounding * before);
    EXPECT_LE(std::abs(impact.impulse_ratio), contact.friction + kRounding);
  });
}

CrashedVehicle anyParty(Random& random) {
  const AgentClass classes[] = {
      AgentClass::kCar, AgentClass::kTruck, AgentClass::kMotorcycle, AgentClass::kPedestrian,
      AgentClass::kBus, AgentClass::kChild, AgentClass::kScooter};
  const AgentClass agent_class = oneOf(classes, random);
  const bool is_person = isOnFoot(agent_class);
  const BoxSize size{is_person ? 0.6 : random.uniform(2.0, 12.0),
                     is_person ? 0.7 : random.uniform(0.8, 2.6)};
  const double yaw = random.uniform(-M_PI, M_PI);
  const Vector2 place = within(random, 3.0);
  CrashedVehicle party{agent_class, size, {0.0, {place.x(), place.y(), yaw}, {0.0, 0.0}}};
  party.state.velocity = random.uniform(0.0, 30.0) * party.state.pose.heading();
  return party;
}

/// Moves the first party back to its first touch of the second. Returns false if there is none.
bool moveToTouch(CrashedVehicle& first, const CrashedVehicle& second) {
  const Vector2 back = -60.0 * first.state.pose.heading();
  Pose2 from = first.state.pose;
  from.x += back.x();
  from.y += back.y();
  const auto ratio = firstContact({from, first.state.pose, first.size},
                                  {second.state.pose, second.state.pose, second.size}, 1e-3);
  if (!ratio || *ratio <= 0.0) return false;
  first.state.pose = interpolate(from, first.state.pose, *ratio);
  return true;
}

CrashedVehicle changed(CrashedVehicle party, bool is_mirrored, double turn, const Vector2& shift) {
  const auto direction = [&](const Vector2& of) {
    const Vector2 flipped(of.x(), is_mirrored ? -of.y() : of.y());
    return compose({0.0, 0.0, turn}, {flipped.x(), flipped.y(), 0.0}).position();
  };
  const Vector2 place = direction(party.state.pose.position()) + shift;
  const double yaw = is_mirrored ? -party.state.pose.yaw : party.state.pose.yaw;
  party.state.pose = {place.x(), place.y(), wrapAngle(yaw + turn)};
  party.state.velocity = direction(party.state.velocity);
  return party;
}

void expectSame(const CrashEffect& effect, const CrashEffect& there, double sign) {
  constexpr double kRounding = 1e-6;
  EXPECT_NEAR(effect.delta_v, there.delta_v, kRounding);
  EXPECT_NEAR(effect.yaw_rate_change, sign * there.yaw_rate_change, kRounding);
  EXPECT_NEAR(angleBetween(effect.force_from, sign * there.force_from), 0.0,
              kRounding / std::max(effect.delta_v, kRounding));
  EXPECT_NEAR(effect.mais3, there.mais3, kRounding);
}

TEST(Severity, IsTheSameForAMirroredTurnedAndMovedCrash) {
  const SeverityOptions& options = embeddedConfig().attack.verification.severity;
  forAllCases([&](Random& random) {
    CrashedVehicle first = anyParty(random);
    const CrashedVehicle second = anyParty(random);
    if (!moveToTouch(first, second)) return;
    const bool is_mirrored = isLikely(random, 0.5);
    const double turn = random.uniform(-M_PI, M_PI);
    const Vector2 shift = within(random, 1000.0);
    const CrashSeverity here = severityOf(first, second, options);
    const CrashSeverity there = severityOf(changed(first, is_mirrored, turn, shift),
                                           changed(second, is_mirrored, turn, shift), options);
    EXPECT_NEAR(here.energy_lost, there.energy_lost, 1e-6 * (1.0 + here.energy_lost));
    expectSame(here.ego, there.ego, is_mirrored ? -1.0 : 1.0);
    expectSame(here.other, there.other, is_mirrored ? -1.0 : 1.0);
  });
}

}  // namespace
}  // namespace forge
