// Boxes, still and in motion, against Boost.Geometry's polygons and against dense sampling.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/geometry/algorithms/append.hpp>
#include <boost/geometry/algorithms/area.hpp>
#include <boost/geometry/algorithms/distance.hpp>
#include <boost/geometry/algorithms/intersection.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "base/geometry/reference_geometry.h"
#include "collision_forge/attack/verify/verification.h"
#include "collision_forge/base/geometry/swept_contact.h"
#include "properties/random_cases.h"

namespace forge {
namespace {

namespace bg = boost::geometry;
using Point = bg::model::d2::point_xy<double>;
using BoostPolygon = bg::model::polygon<Point, false, false>;  // counter-clockwise, open

constexpr double kTolerance = 1e-3;                 // m, of contacts
constexpr double kRounding = 1e-6;                  // m, of coordinates within +-100 m
constexpr double kAreaRounding = 20.0 * kRounding;  // m2, of sides up to 20 m

BoostPolygon polygonOf(const OrientedBox& box) {
  BoostPolygon polygon;
  for (const Vector2& corner : reference::outline(box)) {
    bg::append(polygon.outer(), Point(corner.x(), corner.y()));
  }
  return polygon;
}

double boostDistance(const OrientedBox& a, const OrientedBox& b) {
  return bg::distance(polygonOf(a), polygonOf(b));
}

double boostArea(const OrientedBox& a, const OrientedBox& b) {
  std::vector<BoostPolygon> shared;
  bg::intersection(polygonOf(a), polygonOf(b), shared);
  double area = 0.0;
  for (const BoostPolygon& polygon : shared) area += bg::area(polygon);
  return area;
}

Pose2 randomPose(Random& random, double reach) {
  return {random.uniform(-reach, reach), random.uniform(-reach, reach),
          random.uniform(-M_PI, M_PI)};
}

BoxSize randomSize(Random& random) { return {random.uniform(0.1, 20.0), random.uniform(0.1, 4.0)}; }

/// Sides and corners of boxes like these often meet exactly.
OrientedBox boxOnGrid(Random& random) {
  const auto half = [&](std::size_t count) {
    return 0.5 * static_cast<double>(random.index(count));
  };
  return {{half(24) - 6.0, half(24) - 6.0, M_PI_4 * static_cast<double>(random.index(8))},
          {half(16) + 0.5, half(8) + 0.5}};
}

OrientedBox randomBox(Random& random) {
  return isLikely(random, 0.3) ? boxOnGrid(random)
                               : OrientedBox{randomPose(random, 10.0), randomSize(random)};
}

TEST(BoxesProperties, OverlapDistanceAndSharedAreaEqualThoseOfPolygons) {
  forAllCases([](Random& random) {
    const OrientedBox a = randomBox(random), b = randomBox(random);
    const double apart = boostDistance(a, b), area = boostArea(a, b);
    const bool must_overlap = area > kAreaRounding, may_overlap = apart <= kRounding;
    EXPECT_TRUE(overlaps(a, b) ? may_overlap : !must_overlap) << apart << " m, " << area << " m2";
    EXPECT_EQ(overlaps(a, b), overlaps(b, a));
    EXPECT_NEAR(distance(a, b), apart, kRounding);
    EXPECT_NEAR(intersectionArea(a, b), area, kAreaRounding);
  });
}

/// The motion of two boxes from time 0 to `end`; empty while one of them is out of sight.
struct SharedDrive {
  std::function<std::optional<std::pair<OrientedBox, OrientedBox>>(double time)> boxesAt;
  double end;
  int samples;

  bool touchAt(double time) const {
    const auto boxes = boxesAt(time);
    return boxes && boostDistance(boxes->first, boxes->second) == 0.0;
  }
};

/// Compares a contact time with dense samples: no earlier sample touches, and at that time the
/// boxes are within the tolerance. If a sample touches, bisection between it and the previous
/// sample finds no earlier contact.
void checkAgainstSamples(const std::optional<double>& found, const SharedDrive& drive,
                         double tolerance) {
  double apart = 0.0;
  for (int i = 0; i <= drive.samples; ++i) {
    const double time = drive.end * i / drive.samples;
    if (!drive.touchAt(time)) {
      apart = time;
      continue;
    }
    double touching = time;
    for (int halving = 0; halving < 30 && touching > apart; ++halving) {
      const double middle = 0.5 * (apart + touching);
      (drive.touchAt(middle) ? touching : apart) = middle;
    }
    ASSERT_TRUE(found) << "samples touch at " << touching;
    EXPECT_LE(*found, touching + 1e-9);
    break;
  }
  if (!found) return;
  const auto boxes = drive.boxesAt(*found);
  ASSERT_TRUE(boxes) << "seen at " << *found;
  EXPECT_LE(boostDistance(boxes->first, boxes->second), tolerance + kRounding);
}

BoxMotion randomMotion(Random& random) {
  const Pose2 start = randomPose(random, 15.0);
  const double reach = isLikely(random, 0.5) ? 4.0 : 25.0;  // m
  const Pose2 step{random.uniform(-reach, reach), random.uniform(-0.5 * reach, 0.5 * reach),
                   isLikely(random, 0.3) ? 0.0 : random.uniform(-1.5, 1.5)};
  return {start, compose(start, step), randomSize(random)};
}

TEST(BoxesProperties, FirstContactEqualsDenseSampling) {
  forAllCases([](Random& random) {
    const BoxMotion a = randomMotion(random), b = randomMotion(random);
    const auto boxAt = [](const BoxMotion& motion, double time) {
      return OrientedBox{interpolate(motion.start, motion.end, time), motion.size};
    };
    const SharedDrive drive{
        [&](double time) { return std::make_optional(std::pair(boxAt(a, time), boxAt(b, time))); },
        1.0, 128};
    checkAgainstSamples(firstContact(a, b, kTolerance), drive, kTolerance);
  });
}

/// Adds states of a vehicle that accelerates and steers at random.
template <typename Add>
void drive(Random& random, double interval, const Add& add) {
  Pose2 pose = randomPose(random, 40.0);
  const double speed = random.uniform(0.0, 25.0);
  for (double time = 0.0; time <= 6.0; time += interval) {
    add(time, pose, speed);
    const double turn = random.uniform(-0.6, 0.6) * interval;
    pose = compose(pose, {speed * interval, 0.0, turn});
  }
}

AttackerTrajectory randomTrajectory(Random& random) {
  AttackerTrajectory trajectory{"attacker", AgentClass::kCar, randomSize(random), {}};
  const double interval = oneOf(std::vector{0.1, 0.5, 2.0}, random);
  drive(random, interval, [&](double time, const Pose2& pose, double speed) {
    trajectory.points.push_back({time, pose, speed, 0.0, 0.0});
  });
  return trajectory;
}

/// Returns a track with random gaps, in which the vehicle is out of sight.
Track randomTrack(Random& random) {
  Track track{"other", AgentClass::kCar, randomSize(random), {}};
  const double lost = isLikely(random, 0.5) ? 0.3 : 0.0;
  drive(random, 0.5, [&](double time, const Pose2& pose, double speed) {
    if (!isLikely(random, lost)) track.states.push_back({time, pose, speed * pose.heading()});
  });
  return track;
}

TEST(BoxesProperties, FirstContactTimeEqualsDenseSampling) {
  forAllCases([](Random& random) {
    const AttackerTrajectory trajectory = randomTrajectory(random);
    const Track track = randomTrack(random);
    const double end = trajectory.points.back().time;
    const SharedDrive drive{[&](double time) -> std::optional<std::pair<OrientedBox, OrientedBox>> {
                              const auto state = stateAt(track, time);
                              if (!state) return std::nullopt;
                              return std::pair(
                                  OrientedBox{poseAt(trajectory, time), trajectory.size},
                                  boxAt(track, state->pose));
                            },
                            end, 600};
    checkAgainstSamples(firstContactTime(trajectory, track, end, kTolerance), drive, kTolerance);
  });
}

}  // namespace
}  // namespace forge
