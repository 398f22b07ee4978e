#include "collision_forge/io/lidar/sweep_rays.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "io/lidar/made_up_cloud.h"

namespace forge {
namespace {

constexpr SweepTiming kTiming{100.0, 0.05};

SweepRays raysIn(const PointCloud& cloud) { return raysOf(cloud, CloudLayout(cloud), kTiming); }

/// Ground everywhere, without return in a sector of 60 degrees.
double withGap(const Eigen::Vector3d& direction) {
  const bool is_gap = std::abs(std::atan2(direction.y(), direction.x()) - 1.0) < 0.52;
  return is_gap ? LidarRay::kNoReturn : groundRangeOf(direction);
}

/// Expects every pulse of the sensor that sees the ground or the gap among the rays.
void expectAllPulses(const MadeUpLidar& lidar, const SweepRays& sweep) {
  for (int ring = 0; ring < 8; ++ring) {
    for (int column = 0; column < lidar.columns; ++column) {
      const Eigen::Vector3d pulse = lidar.direction(column, ring);
      double nearest = 10.0;
      for (const LidarRay& ray : sweep.rays) {
        nearest = std::min(nearest, (ray.direction.cast<double>() - pulse).norm());
      }
      EXPECT_LT(nearest, 0.3 * M_PI / 180.0) << ring << " " << column;
    }
  }
}

TEST(SweepRays, RaysOfPointsAreExact) {
  const PointCloud cloud = madeUpCloud({}, groundRangeOf);
  const SweepRays sweep = raysIn(cloud);
  for (std::size_t i = 0; i < cloud.pointCount(); ++i) {
    const Eigen::Vector3d point = CloudLayout(cloud).position(cloud.pointAt(i));
    EXPECT_EQ(sweep.rays[i].point, i);
    EXPECT_LT((sweep.rays[i].range * sweep.rays[i].direction.cast<double>() - point).norm(), 1e-5);
  }
}

TEST(SweepRays, RaysWithoutReturnAreRebuiltInEveryLayout) {
  for (const EmptyPoints empty : {EmptyPoints::kLeftOut, EmptyPoints::kZero, EmptyPoints::kNan}) {
    for (const bool is_organised : {false, true}) {
      if (is_organised && empty == EmptyPoints::kLeftOut) continue;
      MadeUpLidar lidar;
      lidar.empty = empty;
      lidar.is_organised = is_organised;
      const SweepRays sweep = raysIn(madeUpCloud(lidar, withGap));
      EXPECT_EQ(sweep.empty_points, empty);
      EXPECT_TRUE(sweep.notes.empty());
      expectAllPulses(lidar, sweep);
    }
  }
}

TEST(SweepRays, ZeroRangesThatTheEgoMotionMovedAreNoReturns) {
  MadeUpLidar lidar;
  lidar.empty = EmptyPoints::kZero;
  PointCloud cloud = madeUpCloud(lidar, withGap);
  const CloudLayout layout(cloud);
  for (std::size_t i = 0; i < cloud.pointCount(); ++i) {
    const double rest = 1.0 - static_cast<double>(i) / static_cast<double>(cloud.pointCount());
    const Eigen::Vector3d moved =
        layout.position(cloud.pointAt(i)) - rest * Eigen::Vector3d(0.0, 0.5, 0.0);
    layout.setPosition(cloud.pointAt(i), moved);
  }
  const SweepRays sweep = raysIn(cloud);
  EXPECT_EQ(sweep.empty_points, EmptyPoints::kZero);
  for (const LidarRay& ray : sweep.rays) EXPECT_GT(ray.range, 1.0F);
}

TEST(SweepRays, RingsComeFromTheOrderWithoutARingField) {
  MadeUpLidar lidar;
  lidar.ring_type = 0;
  lidar.empty = EmptyPoints::kZero;
  const SweepRays sweep = raysIn(madeUpCloud(lidar, withGap));
  EXPECT_TRUE(sweep.notes.empty());
  for (const LidarRay& ray : sweep.rays) EXPECT_EQ(ray.ring, ray.point % 16);
  expectAllPulses(lidar, sweep);
}

TEST(SweepRays, RingsComeFromTheElevationOfAKnownSensor) {
  MadeUpLidar lidar;
  lidar.ring_type = 0;
  lidar.lowest = -15.0 * M_PI / 180.0;
  lidar.step = 2.0 * M_PI / 180.0;
  const SweepRays sweep = raysIn(madeUpCloud(lidar, withGap));
  EXPECT_TRUE(sweep.notes.empty());
  for (const LidarRay& ray : sweep.rays) {
    EXPECT_NEAR(std::asin(ray.direction.z()), lidar.lowest + lidar.step * ray.ring, 1e-3);
  }
}

TEST(SweepRays, ARingFieldThatLiesIsIgnoredAndNamed) {
  PointCloud cloud = madeUpCloud({}, withGap);
  const CloudLayout layout(cloud);
  for (std::size_t i = 0; i < cloud.pointCount(); ++i) {
    layout.ring->set(cloud.pointAt(i), static_cast<double>(i * 7 % 16));
  }
  const SweepRays sweep = raysIn(cloud);
  EXPECT_THAT(sweep.notes,
              testing::Contains(testing::HasSubstr("ring field does not follow the elevation")));
  EXPECT_EQ(sweep.rays.size(), cloud.pointCount());
}

TEST(SweepRays, TimesComeFromTheFieldOrFromThePlaceInTheTurn) {
  for (const std::uint8_t type : {0, 6, 7}) {
    MadeUpLidar lidar;
    lidar.time_type = type;
    const SweepRays sweep = raysIn(madeUpCloud(lidar, groundRangeOf));
    const float first = sweep.rays.front().time;
    float last = first;
    for (const LidarRay& ray : sweep.rays) {
      if (!ray.is_missing) last = ray.time;
    }
    EXPECT_NEAR(first, type == 0 ? -0.05 : type == 6 ? 0.0 : -0.1, 1e-3);
    EXPECT_NEAR(last, type == 6 ? 0.1 : 0.0, 2e-3);
  }
}

TEST(SweepRays, EmptyCloudsHaveNoRays) {
  MadeUpLidar lidar;
  const PointCloud none = madeUpCloud(lidar, [](const auto&) { return LidarRay::kNoReturn; });
  EXPECT_TRUE(raysIn(none).rays.empty());
  lidar.empty = EmptyPoints::kNan;
  const PointCloud nan = madeUpCloud(lidar, [](const auto&) { return LidarRay::kNoReturn; });
  EXPECT_EQ(raysIn(nan).rays.size(), nan.pointCount());
}

TEST(GroundBelow, IsTheLevelAroundTheBoxWhateverStandsOnIt) {
  const auto withCar = [](const Eigen::Vector3d& direction) {
    const double range = groundRangeOf(direction);
    const Eigen::Vector3d point = range * direction;
    return std::isfinite(range) && (point - Eigen::Vector3d(8.0, 0.0, -1.8)).norm() < 1.0
               ? range * 0.9
               : range;
  };
  MadeUpLidar lidar;
  lidar.columns = 360;
  const SweepRays sweep = raysIn(madeUpCloud(lidar, withCar));
  const Eigen::Isometry3d pose(Eigen::Translation3d(8.0, 0.0, -1.5));
  EXPECT_NEAR(*groundBelow(sweep, pose, {4.5, 1.9}), -0.3, 0.03);
  EXPECT_FALSE(
      groundBelow(sweep, Eigen::Isometry3d(Eigen::Translation3d(300.0, 0.0, 0.0)), {4.5, 1.9}));
}

}  // namespace
}  // namespace forge
