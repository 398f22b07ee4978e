#include "collision_forge/base/geometry/arc_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "base/geometry/reference_geometry.h"

namespace forge {
namespace {

void expectSamePose(const Pose2& a, const Pose2& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(angleBetween(a.yaw, b.yaw), 0.0, tolerance);
}

// Midpoint steps along the heading, within each piece.
Pose2 integrate(const ArcPath& path, double arc_length) {
  constexpr int kSteps = 4000;
  Pose2 pose = path.start;
  double rest = arc_length;
  for (std::size_t i = 0; i < 3; ++i) {
    const double curvature =
        (path.shape[i] == 'L') / path.radius - (path.shape[i] == 'R') / path.radius;
    const double step = std::min(rest, path.segment_length[i]) / kSteps;
    for (int k = 0; k < kSteps; ++k) {
      const double yaw = pose.yaw + 0.5 * curvature * step;
      pose = {pose.x + step * std::cos(yaw), pose.y + step * std::sin(yaw),
              pose.yaw + curvature * step};
    }
    rest -= step * kSteps;
  }
  return pose;
}

ArcPath randomPath(reference::Random& random) {
  static constexpr char kLetters[] = {'L', 'S', 'R'};
  ArcPath path;
  path.start = random.pose(500.0);
  for (char& letter : path.shape) {
    letter = kLetters[static_cast<int>(random.between(0.0, 2.999))];
  }
  path.radius = std::exp(random.between(std::log(3.0), std::log(20000.0)));
  path.segment_length = {random.between(0.0, 30.0), random.between(0.0, 30.0),
                         random.between(0.0, 30.0)};
  return path;
}

TEST(ArcPath, AgreesWithNumericalIntegration) {
  reference::Random random(2);
  for (int i = 0; i < 300; ++i) {
    const ArcPath path = randomPath(random);
    const double arc_length = random.between(0.0, path.length());
    expectSamePose(poseAt(path, arc_length), integrate(path, arc_length), 1e-5);
    expectSamePose(poseAt(path, path.length()), integrate(path, path.length()), 1e-5);
  }
}

TEST(ArcPath, DiscretizesLikeThePublishedCode) {
  // Counts of int(max(ceil(length / resolution) + 1.5, 2)).
  const ArcPath exact{{}, {'S', 'S', 'S'}, 1.0, {1.0, 0.0, 0.0}};
  EXPECT_EQ(discretize({exact}, 0.5).size(), 3u);
  const ArcPath longer{{}, {'S', 'S', 'S'}, 1.0, {1.01, 0.0, 0.0}};
  EXPECT_EQ(discretize({longer}, 0.5).size(), 4u);
  const ArcPath empty{{}, {'S', 'S', 'S'}, 1.0, {0.0, 0.0, 0.0}};
  EXPECT_EQ(discretize({empty}, 0.5).size(), 2u);
  EXPECT_TRUE(discretize({}, 0.5).empty());
  EXPECT_THROW(discretize({exact}, 0.0), std::invalid_argument);
}

TEST(ArcPath, DiscretizesEvenlyAndJoinsOnce) {
  reference::Random random(3);
  for (int i = 0; i < 100; ++i) {
    const ArcPath first = randomPath(random);
    ArcPath second = randomPath(random);
    second.start = poseAt(first, first.length());
    const auto alone = discretize({first}, 0.7);
    const auto poses = discretize({first, second}, 0.7);
    ASSERT_EQ(poses.size(), alone.size() + discretize({second}, 0.7).size() - 1);
    expectSamePose(poses.front(), first.start, 1e-12);
    expectSamePose(poses[alone.size() - 1], second.start, 1e-9);
    expectSamePose(poses.back(), poseAt(second, second.length()), 1e-9);
    const double step = first.length() / (alone.size() - 1);
    EXPECT_LE(step, 0.7);
    for (std::size_t k = 0; k < alone.size(); ++k) {
      expectSamePose(poses[k], poseAt(first, step * k), 1e-9);
    }
    for (std::size_t k = 1; k < poses.size(); ++k) {
      EXPECT_GT((poses[k].position() - poses[k - 1].position()).norm(), 0.0);
    }
  }
}

}  // namespace
}  // namespace forge
