#include "collision_forge/attack/severity/impact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace forge {
namespace {

constexpr double kDegree = M_PI / 180.0;
constexpr double kSticking = 10.0;  // friction at which no test slides

/// A vehicle of the oblique tests: its contact point is given in its own frame.
struct TestVehicle {
  double mass, inertia;
  double heading;  // rad
  Vector2 arm;     // m
  double speed;    // m/s
};

ImpactBody bodyOf(const TestVehicle& vehicle, const Vector2& point) {
  const Pose2 frame{0.0, 0.0, vehicle.heading};
  const Vector2 arm = compose(frame, {vehicle.arm.x(), vehicle.arm.y(), 0.0}).position();
  return {vehicle.mass, vehicle.inertia, point - arm, vehicle.speed * frame.heading(), 0.0};
}

Vector2 unit(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// NHTSA 4363, 4364, 4438 and 4474, car against SUV, as SAE 2006-01-0908 computes them.
TEST(PlanarImpact, AgreesWithThePublishedObliqueTests) {
  struct Case {
    TestVehicle car, suv;
    double normal, restitution;              // degrees
    double ratio, dv1, dv2, dw1, dw2, pdof;  // of the paper; m/s, rad/s, degrees
  };
  const double west = -M_PI;
  const Case cases[] = {
      {{1565.4, 2918, west, {.725, -.320}, 15.69},
       {2129.8, 3803, -32 * kDegree, {1.708, -.320}, 15.65},
       -55,
       .126,
       .51,
       17.67,
       12.99,
       .55,
       -3.19,
       152.0},
      {{1565.4, 2918, west, {.490, -.502}, 15.65},
       {2355.3, 4831, -30 * kDegree, {2.123, -.420}, 15.60},
       -51.9,
       .089,
       .42,
       17.85,
       11.86,
       -1.88,
       -2.56,
       150.6},
      {{1499.4, 2801, west, {.697, -.493}, 15.51},
       {2143.4, 3917, -30 * kDegree, {1.484, -.348}, 15.65},
       -50.7,
       .095,
       .44,
       17.77,
       12.43,
       -1.18,
       -2.90,
       153.1},
      {{1499.4, 2801, west, {.727, -.503}, 15.65},
       {2112.4, 3882, -31.6 * kDegree, {1.618, -.440}, 15.65},
       -51.8,
       .150,
       .40,
       18.07,
       12.83,
       -.70,
       -3.38,
       150.0},
  };
  for (const Case& one : cases) {
    const Vector2 point(3.0, -2.0);
    const ImpactContact contact{point, unit(one.normal * kDegree), one.restitution, kSticking};
    const Impact impact = planarImpact(bodyOf(one.car, point), bodyOf(one.suv, point), contact);
    EXPECT_NEAR(impact.first.velocity.norm(), one.dv1, 0.08);
    EXPECT_NEAR(impact.second.velocity.norm(), one.dv2, 0.08);
    EXPECT_NEAR(impact.first.yaw_rate, one.dw1, 3.0 * kDegree);
    EXPECT_NEAR(impact.second.yaw_rate, one.dw2, 3.0 * kDegree);
    EXPECT_NEAR(std::abs(impact.impulse_ratio), one.ratio, 0.01);
    const double direction = std::atan2(impact.impulse.y(), impact.impulse.x());
    EXPECT_NEAR(std::abs(angleBetween(one.car.heading, direction)), one.pdof * kDegree, kDegree);
  }
}

/// Two cars of 1500 kg and 2500 kg m2; the first drives along +x and touches at the origin.
struct TwoCars {
  ImpactBody first{1500.0, 2500.0, {-2.3, 0.0}, {15.0, 0.0}, 0.0};
  ImpactBody second{1500.0, 2500.0, {2.3, 0.0}, {0.0, 0.0}, 0.0};

  Impact impact() const {
    return planarImpact(first, second, {{0.0, 0.0}, {1.0, 0.0}, 0.1, kSticking});
  }
};

TEST(PlanarImpact, RearEndSharesTheClosingSpeed) {
  TwoCars cars;
  cars.second.velocity = {5.0, 0.0};
  const Impact impact = cars.impact();
  EXPECT_NEAR(impact.first.velocity.x(), -5.50, 1e-9);  // (1 + e) * 10 / 2
  EXPECT_NEAR(impact.second.velocity.x(), 5.50, 1e-9);
  EXPECT_NEAR(impact.energy_lost, 0.5 * 750.0 * 100.0 * (1.0 - 0.01), 1e-6);
}

TEST(PlanarImpact, OffsetHeadOnTurnsBothTheSameWay) {
  TwoCars cars;
  cars.second.velocity = {-15.0, 0.0};
  cars.first.center.y() = -0.54;
  cars.second.center.y() = 0.54;
  const Impact impact = cars.impact();
  EXPECT_NEAR(impact.first.velocity.norm(), 16.09, 0.01);
  EXPECT_NEAR(impact.second.velocity.norm(), 16.09, 0.01);
  EXPECT_NEAR(impact.first.yaw_rate, 1.23, 0.01);
  EXPECT_NEAR(impact.second.yaw_rate, 1.23, 0.01);
}

TEST(PlanarImpact, SideImpactsTurnTheStruckCarByItsLever) {
  TwoCars middle;
  middle.second.center = {0.9, 0.0};
  middle.second.velocity = {0.0, 10.0};
  const Impact across = middle.impact();
  EXPECT_NEAR(across.first.velocity.norm(), 8.43, 0.05);
  EXPECT_NEAR(std::abs(across.first.yaw_rate), 2.40, 0.1);
  EXPECT_NEAR(std::abs(across.second.yaw_rate), 1.01, 0.1);
  TwoCars behind;
  behind.second.center = {0.9, 1.3};  // heads to +y and is touched 1.3 m behind its middle
  const Impact rear_part = behind.impact();
  EXPECT_NEAR(rear_part.first.velocity.norm(), 5.71, 0.05);
  EXPECT_NEAR(std::abs(rear_part.second.yaw_rate), 3.98, 0.1);
}

TEST(PlanarImpact, SlidesToTheEndIfFrictionIsTooLow) {
  TwoCars cars;
  cars.second.velocity = {0.0, 10.0};
  const ImpactContact smooth{{0.0, 0.0}, {1.0, 0.0}, 0.1, 0.1};
  const Impact impact = planarImpact(cars.first, cars.second, smooth);
  EXPECT_NEAR(std::abs(impact.impulse_ratio), 0.1, 1e-12);
  EXPECT_LT(std::abs(cars.impact().first.velocity.y()), 10.0);
  EXPECT_GT(impact.first.velocity.y(), 0.0) << "dragged along by the other car";
}

TEST(PlanarImpact, BodiesThatSeparateGetNoImpulse) {
  TwoCars cars;
  cars.second.velocity = {20.0, 3.0};
  const Impact impact = cars.impact();
  EXPECT_EQ(impact.impulse.norm(), 0.0);
  EXPECT_EQ(impact.energy_lost, 0.0);
}

void expectRefused(const ImpactBody& second, const std::string& reason) {
  try {
    planarImpact(TwoCars().first, second, {{0.0, 0.0}, {1.0, 0.0}, 0.1, 0.5});
    ADD_FAILURE() << "not refused: " << reason;
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(error.what(), reason);
  }
}

TEST(PlanarImpact, RefusesBodiesWithoutMassAndNumbersThatAreNotFinite) {
  ImpactBody body = TwoCars().second;
  body.mass = 0.0;
  expectRefused(body, "second body: mass 0 kg is not positive");
  body.mass = std::nan("");
  expectRefused(body, "second body: mass or yaw inertia is not finite");
  body = TwoCars().second;
  body.yaw_inertia = -1.0;
  expectRefused(body, "second body: yaw inertia -1 kg m2 is not positive");
  body = TwoCars().second;
  body.velocity.y() = std::numeric_limits<double>::infinity();
  expectRefused(body, "second body: position, velocity or yaw rate is not finite");
  const TwoCars cars;
  for (const ImpactContact& contact : {ImpactContact{{0.0, 0.0}, {2.0, 0.0}, 0.1, 0.5},
                                       ImpactContact{{0.0, 0.0}, {1.0, 0.0}, 1.1, 0.5},
                                       ImpactContact{{0.0, 0.0}, {1.0, 0.0}, 0.1, -0.5},
                                       ImpactContact{{0.0, std::nan("")}, {1.0, 0.0}, 0.1, 0.5}}) {
    EXPECT_THROW(planarImpact(cars.first, cars.second, contact), std::invalid_argument);
  }
}

}  // namespace
}  // namespace forge
