// Random bodies in random clouds of random layouts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <utility>
#include <vector>

#include "collision_forge/io/lidar/cloud_injection.h"
#include "io/lidar/made_up_cloud.h"
#include "properties/random_cases.h"

namespace forge {
namespace {

constexpr double kNoise = 0.02;     // m, of ranges
constexpr double kMostNoise = 3.0;  // standard deviations, as editCloud() limits it
constexpr int kInjections = 10;     // per case
constexpr SweepTiming kTiming{1000.0, 0.1};

MadeUpLidar randomLidar(Random& random) {
  MadeUpLidar lidar;
  lidar.columns = 30 + static_cast<int>(random.index(40));
  lidar.empty = static_cast<EmptyPoints>(random.index(3));
  lidar.is_organised = lidar.empty != EmptyPoints::kLeftOut && isLikely(random, 0.5);
  lidar.is_bigendian = isLikely(random, 0.2);
  lidar.ring_type = oneOf(std::vector<std::uint8_t>{2, 4, 7}, random);
  lidar.time_type = oneOf(std::vector<std::uint8_t>{0, 6, 7}, random);
  lidar.has_unknown = isLikely(random, 0.3);
  return lidar;
}

/// Ground, with walls in some directions and no return in others.
RangeOf randomWorld(Random& random) {
  std::vector<double> walls;
  for (int i = 0; i < 12; ++i) walls.push_back(random.uniform(3.0, 60.0));
  const double wall_share = random.uniform(0.0, 0.6);
  const double none_share = random.uniform(0.0, 0.4);
  return [=](const Eigen::Vector3d& direction) {
    const double turn = (std::atan2(direction.y(), direction.x()) + M_PI) / (2.0 * M_PI);
    const double sector = turn * static_cast<double>(walls.size());
    const double within = sector - std::floor(sector);
    const double ground = groundRangeOf(direction);
    if (within < wall_share) {
      return std::min(ground, walls[static_cast<std::size_t>(sector) % walls.size()]);
    }
    return within > 1.0 - none_share ? double{LidarRay::kNoReturn} : ground;
  };
}

PosedBody randomBody(Random& random) {
  constexpr AgentClass kClasses[] = {AgentClass::kCar,        AgentClass::kTruck,
                                     AgentClass::kBus,        AgentClass::kTrailer,
                                     AgentClass::kMotorcycle, AgentClass::kBicycle,
                                     AgentClass::kPedestrian, AgentClass::kStaticObject};
  PosedBody posed;
  posed.body =
      lidarBodyOf(oneOf(kClasses, random),
                  {random.uniform(0.5, 12.0), random.uniform(0.5, 3.0), random.uniform(1.0, 4.0)},
                  random.uniform(0.0, 10.0));
  const double bearing = random.uniform(-M_PI, M_PI);
  const double distance = posed.body.size.norm() / 2.0 + random.uniform(2.0, 30.0);
  posed.end = Eigen::Translation3d(distance * std::cos(bearing), distance * std::sin(bearing),
                                   random.uniform(-2.0, -1.5)) *
              Eigen::AngleAxisd(random.uniform(-M_PI, M_PI), Eigen::Vector3d::UnitZ());
  posed.begin = posed.end;
  if (isLikely(random, 0.5)) {
    posed.begin_time = -0.1;
    posed.begin = posed.end * Eigen::Translation3d(random.uniform(-2.0, 2.0), 0.0, 0.0) *
                  Eigen::AngleAxisd(random.uniform(-0.05, 0.05), Eigen::Vector3d::UnitZ());
  }
  return posed;
}

/// Returns the point in the frame of the body without its fit.
Eigen::Vector3d inBody(const PosedBody& posed, double time, const Eigen::Vector3d& point) {
  return Eigen::Vector3d(1.0 / posed.fit, 1.0 / posed.fit, 2.0 / (1.0 + posed.fit))
      .cwiseProduct(posed.poseAt(time).inverse() * point);
}

/// Returns how deep a point is inside the body, m; negative outside.
double depthIn(const LidarBody& body, const Eigen::Vector3d& point) {
  double deepest = -INFINITY;
  for (const ConvexPiece& piece : body.pieces) {
    double depth = INFINITY;
    for (const auto& plane : piece.planes) {
      depth = std::min(depth, plane.offset - plane.normal.dot(point));
    }
    deepest = std::max(deepest, depth);
  }
  return deepest;
}

/// Points by their direction in whole steps of the sensor, so that a cloud before an edit and the
/// one after it can be compared without the rays that the edit used.
class PointsByPulse {
 public:
  PointsByPulse(const PointCloud& cloud, const MadeUpLidar& lidar) : cloud_(cloud), layout_(cloud) {
    for (std::size_t i = 0; i < cloud.pointCount(); ++i) {
      const Eigen::Vector3d point = layout_.position(cloud.pointAt(i));
      if (!(point.norm() > 0.0)) continue;
      const Eigen::Vector3d direction = point.normalized();
      const int ring =
          static_cast<int>(std::lround((std::asin(direction.z()) - lidar.lowest) / lidar.step));
      const double turned = (3.0 - std::atan2(direction.y(), direction.x())) / (2.0 * M_PI);
      const auto steps = static_cast<int>(std::lround(turned * lidar.columns));
      const int column = (steps + lidar.columns) % lidar.columns;
      const Eigen::Vector3d pulse = lidar.direction(column, ring);
      EXPECT_LT(std::acos(std::min(1.0, pulse.dot(direction))), 0.3 * M_PI / 180.0);
      EXPECT_EQ(layout_.ring->get(cloud.pointAt(i)), ring);
      EXPECT_TRUE(points_.emplace(std::pair(column, ring), i).second) << column << " " << ring;
    }
  }

  const std::map<std::pair<int, int>, std::size_t>& points() const { return points_; }
  double range(std::size_t point) const { return layout_.position(cloud_.pointAt(point)).norm(); }
  const std::uint8_t* bytes(std::size_t point) const { return cloud_.pointAt(point); }
  const CloudLayout& layout() const { return layout_; }

 private:
  const PointCloud& cloud_;
  CloudLayout layout_;
  std::map<std::pair<int, int>, std::size_t> points_;
};

/// Checks that a ray that ends at `end` met no body before.
void expectFree(const std::vector<PosedBody>& bodies, double time, const Eigen::Vector3d& end) {
  constexpr double kSample = 0.1;  // m
  constexpr double kDeep = 0.1;    // m, with noise
  for (const PosedBody& posed : bodies) {
    const double reach = posed.body.size.norm() + 3.0;
    for (double s = kSample; s < end.norm(); s += kSample) {
      const Eigen::Vector3d point = s * end.normalized();
      if ((point - posed.end.translation()).norm() > reach) continue;
      EXPECT_LT(depthIn(posed.body, inBody(posed, time, point)), kDeep)
          << s << " of " << end.norm();
    }
  }
}

void checkInjection(const MadeUpLidar& lidar, const RangeOf& world, bool is_thorough,
                    Random& random) {
  const PointCloud before = madeUpCloud(lidar, world);
  PointCloud after = before;
  const CloudLayout layout(before);
  const SweepRays sweep = raysOf(before, layout, kTiming);
  std::vector<PosedBody> bodies;
  for (std::size_t i = random.index(3); i < 3; ++i) bodies.push_back(randomBody(random));
  // Without a field, times come from the place among the points that are there.
  for (PosedBody& posed : bodies) {
    if (lidar.time_type == 0) posed.begin = posed.end;
  }
  const auto seed = static_cast<std::uint64_t>(random.index(1000000));
  const SurfaceReturns surfaces;
  const CloudEdit edit{bodies, {}, nullptr, kNoise, seed};
  const CloudChange change = editCloud(after, layout, sweep, edit, surfaces);
  PointCloud again = before;
  editCloud(again, layout, sweep, edit, surfaces);
  EXPECT_EQ(again.data, after.data);
  EXPECT_LE(after.pointCount(), static_cast<std::size_t>(lidar.columns) * lidar.rings);
  if (lidar.empty != EmptyPoints::kLeftOut) {
    EXPECT_EQ(after.width, before.width);
    EXPECT_EQ(after.height, before.height);
  }
  for (PosedBody& posed : bodies) posed.fit = surfaces.fitOf(posed.body);

  const PointsByPulse old_points(before, lidar);
  const PointsByPulse new_points(after, lidar);
  std::size_t on_bodies = 0;
  std::size_t last = 0;
  std::map<std::size_t, std::size_t> kept;  // new place by old place
  for (const auto& [pulse, place] : new_points.points()) {
    const auto recorded = old_points.points().find(pulse);
    const bool was_there = recorded != old_points.points().end();
    const Eigen::Vector3d end = new_points.layout().position(new_points.bytes(place));
    const bool is_same =
        was_there && std::memcmp(new_points.bytes(place), old_points.bytes(recorded->second),
                                 before.point_step) == 0;
    if (is_same) kept[recorded->second] = place;
    const double since = 0.1 * pulse.first / lidar.columns;
    const double time = lidar.time_type == 6 ? since : since - 0.1;
    // Where a turn ends and the next begins is unknown to within the points that are left out,
    // which are many in rings above the horizon.
    const int seam = lidar.columns / 4;
    const bool is_seam = lidar.empty == EmptyPoints::kLeftOut &&
                         (pulse.first < seam || pulse.first >= lidar.columns - seam);
    if (!is_same) {
      ++on_bodies;
      if (was_there) {
        EXPECT_LE(end.norm(), old_points.range(recorded->second) + 1e-3);
      }
      double nearest = INFINITY;
      for (const PosedBody& posed : bodies) {
        nearest = std::min(nearest, std::abs(depthIn(posed.body, inBody(posed, time, end))));
      }
      if (!is_seam) {
        EXPECT_LT(nearest, kMostNoise * kNoise / 0.8 + 0.03);
      }
    }
    if (is_thorough && !is_seam) expectFree(bodies, time, end);
  }
  EXPECT_EQ(on_bodies, change.on_bodies);
  for (const auto& [old_place, new_place] : kept) {
    EXPECT_GE(new_place, last) << "order of " << old_place;
    last = new_place;
  }
}

TEST(LidarInjections, ObeyTheRulesOfRays) {
  forAllCases([](Random& random) {
    const MadeUpLidar lidar = randomLidar(random);
    const RangeOf world = randomWorld(random);
    for (int i = 0; i < kInjections; ++i) checkInjection(lidar, world, i == 0, random);
  });
}

}  // namespace
}  // namespace forge
