#include "collision_forge/base/geometry/swept_contact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/geometry/reference_geometry.h"

namespace forge {
namespace {

constexpr int kSteps = 2000;
constexpr double kTolerance = 1e-3;

OrientedBox boxAt(const BoxMotion& motion, double time) {
  return {interpolate(motion.start, motion.end, time), motion.size};
}

double distanceAt(const BoxMotion& a, const BoxMotion& b, double time) {
  return reference::distance(boxAt(a, time), boxAt(b, time));
}

// First of many fine time steps at which the boxes share a point, and the smallest distance of all.
struct Stepped {
  std::optional<double> contact;
  double least_distance = std::numeric_limits<double>::infinity();
};

Stepped stepThrough(const BoxMotion& a, const BoxMotion& b) {
  Stepped result;
  for (int i = 0; i <= kSteps && !result.contact; ++i) {
    const double time = static_cast<double>(i) / kSteps;
    const double distance = distanceAt(a, b, time);
    result.least_distance = std::min(result.least_distance, distance);
    if (distance == 0.0) {
      result.contact = time;
    }
  }
  return result;
}

// Largest decrease of the distance between the boxes in one of the fine steps.
double closingPerStep(const BoxMotion& a, const BoxMotion& b) {
  double closing = 0.0;
  for (const BoxMotion& m : {a, b}) {
    closing += (m.end.position() - m.start.position()).norm() +
               std::abs(angleBetween(m.start.yaw, m.end.yaw)) * circumradius(m.size);
  }
  return closing / kSteps;
}

struct Counts {
  int contacts = 0;
  int misses = 0;
};

void compare(const BoxMotion& a, const BoxMotion& b, Counts& counts) {
  const std::optional<double> found = firstContact(a, b, kTolerance);
  const Stepped stepped = stepThrough(a, b);
  if (stepped.contact) {
    ++counts.contacts;
    ASSERT_TRUE(found.has_value()) << "stepping meets at " << *stepped.contact;
    EXPECT_LE(*found, *stepped.contact + 1e-9);
  }
  if (!found) {
    ++counts.misses;
    EXPECT_GT(stepped.least_distance, 0.0);
    return;
  }
  EXPECT_GE(*found, 0.0);
  EXPECT_LE(*found, 1.0);
  EXPECT_LE(distanceAt(a, b, *found), kTolerance + 1e-9);
  EXPECT_LE(stepped.least_distance, kTolerance + closingPerStep(a, b));
  for (int i = 0; i < 50; ++i) {  // apart at every earlier time
    EXPECT_GT(distanceAt(a, b, *found * i / 50.0), *found > 0.0 ? 0.0 : -1.0);
  }
}

TEST(FirstContact, AgreesWithFineSteppingForSlowMotions) {
  reference::Random random(12);
  Counts counts;
  for (int i = 0; i < 500; ++i) {
    BoxMotion motions[2];
    for (BoxMotion& motion : motions) {
      const OrientedBox box = random.box(8.0);
      const Pose2 step{random.between(-4, 4), random.between(-2, 2), random.between(-1.5, 1.5)};
      motion = {box.center, compose(box.center, step), box.size};
    }
    compare(motions[0], motions[1], counts);
  }
  EXPECT_GT(counts.contacts, 100);
  EXPECT_GT(counts.misses, 100);
}

// 40 m/s for 0.5 s: the boxes are apart at both ends of nearly every motion.
TEST(FirstContact, DoesNotTunnelAtFortyMetresPerSecond) {
  reference::Random random(13);
  Counts counts;
  int tunnels = 0;
  for (int i = 0; i < 600; ++i) {
    const double direction = random.between(-M_PI, M_PI);
    const Vector2 way(std::cos(direction), std::sin(direction));
    const OrientedBox still = random.box(3.0);
    const OrientedBox fast{{0, 0, direction + random.between(-0.3, 0.3)}, random.box(1.0).size};
    const Vector2 side = random.between(-6.0, 6.0) * Vector2(-way.y(), way.x());
    const Vector2 from = side - 10.0 * way;
    const Vector2 to = side + 10.0 * way;
    const BoxMotion a{still.center, compose(still.center, {0, 0, 0.2}), {still.size.length, 1.0}};
    const BoxMotion b{{from.x(), from.y(), fast.center.yaw},
                      {to.x(), to.y(), fast.center.yaw + random.between(-0.5, 0.5)},
                      {1.0, fast.size.width}};
    compare(a, b, counts);
    tunnels += firstContact(a, b) && distanceAt(a, b, 0.0) > 0.0 && distanceAt(a, b, 1.0) > 0.0;
  }
  EXPECT_GT(tunnels, 100);
  EXPECT_GT(counts.misses, 100);
}

TEST(FirstContact, TouchingAtTheStartIsZero) {
  const BoxSize size{4.0, 2.0};
  EXPECT_EQ(firstContact({{0, 0, 0}, {9, 0, 0}, size}, {{1, 0, 0}, {-9, 0, 1}, size}), 0.0);
  EXPECT_EQ(firstContact({{0, 0, 0}, {-9, 0, 0}, size}, {{4, 0, 0}, {9, 0, 0}, size}), 0.0);
}

TEST(FirstContact, TakesTheShorterTurn) {
  // From 170 to -170 degrees the bar passes 180, not 0.
  const BoxMotion bar{{0, 0, 17 * M_PI / 18}, {0, 0, -17 * M_PI / 18}, {10.0, 0.1}};
  EXPECT_TRUE(firstContact(bar, {{-4, 0, 0}, {-4, 0, 0}, {0.1, 0.1}}));
  EXPECT_FALSE(firstContact(bar, {{0, 4, 0}, {0, 4, 0}, {0.1, 0.1}}));
}

TEST(FirstContact, ZeroSizeBoxesMeetOnlyHeadOn) {
  const BoxMotion a{{-5, 0, 0}, {5, 0, 0}, {}};
  EXPECT_TRUE(firstContact(a, {{5, 0, 0}, {-5, 0, 0}, {}}));
  EXPECT_FALSE(firstContact(a, {{5, 0.01, 0}, {-5, 0.01, 0}, {}}));
}

TEST(FirstContact, EndsForExtremeInput) {
  const BoxMotion a{{-1e12, 0, 0}, {1e12, 0, 3}, {4.0, 2.0}};
  EXPECT_TRUE(firstContact(a, {{0, 0, 0}, {0, 0, 0}, {4.0, 2.0}}, 0.0));
  // Pass each other at 2 mm while rotating slightly: grazing takes the most steps.
  const BoxMotion left{{0, 2.002, 0.0}, {20, 2.002, 0.0}, {4.0, 2.0}};
  const BoxMotion right{{20, 0, -5e-4}, {0, 0, 5e-4}, {4.0, 2.0}};
  EXPECT_FALSE(firstContact(left, right, 0.0));
}

TEST(FirstContact, RejectsNumbersThatAreNotFinite) {
  const BoxMotion good{{0, 0, 0}, {1, 0, 0}, {4.0, 2.0}};
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(firstContact(good, {{bad, 0, 0}, {1, 0, 0}, {4.0, 2.0}}), std::invalid_argument);
    EXPECT_THROW(firstContact({{0, 0, 0}, {1, 0, bad}, {4.0, 2.0}}, good), std::invalid_argument);
    EXPECT_THROW(firstContact(good, {{0, 0, 0}, {1, 0, 0}, {bad, 2.0}}), std::invalid_argument);
    EXPECT_THROW(firstContact(good, good, bad), std::invalid_argument);
  }
}

}  // namespace
}  // namespace forge
