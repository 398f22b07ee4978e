#include "collision_forge/base/map/area_raster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <thread>

#include "collision_forge/base/map/lane_queries.h"

namespace forge {
namespace {

constexpr double kHalfCell = 0.36;  // m, a little more than half the diagonal of a cell

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  Vector2 in(double low, double high) { return {between(low, high), between(low, high)}; }

 private:
  std::mt19937 engine_;
};

Polygon rectangle(double min_x, double min_y, double max_x, double max_y) {
  return {{{min_x, min_y}, {max_x, min_y}, {max_x, max_y}, {min_x, max_y}}, {}};
}

/// A star around a centre, with corners at random distances.
std::vector<Vector2> star(Random& random, const Vector2& middle, double low, double high) {
  std::vector<Vector2> ring;
  for (int i = 0; i < 13; ++i) {
    const double angle = 2.0 * M_PI * (i + random.between(0.0, 0.5)) / 13.0;
    ring.push_back(middle + random.between(low, high) * Vector2(std::cos(angle), std::sin(angle)));
  }
  return ring;
}

/// Overlapping stars over several tiles, every other one with two holes; either orientation.
LaneMap stars(unsigned seed) {
  Random random(seed);
  LaneMap map;
  for (int i = 0; i < 6; ++i) {
    const Vector2 middle = random.in(-60.0, 60.0) + Vector2(1000.0, -500.0);
    Polygon polygon{star(random, middle, 15.0, 40.0), {}};
    if (i % 2 == 0) {
      polygon.holes = {star(random, middle + Vector2(-5.0, 0.0), 2.0, 4.0),
                       star(random, middle + Vector2(5.0, 0.0), 2.0, 4.0)};
      std::reverse(polygon.exterior.begin(), polygon.exterior.end());
    }
    map.drivable_area.push_back(polygon);
  }
  return map;
}

bool isInside(const LaneMap& map, const Vector2& point) {
  return std::any_of(map.drivable_area.begin(), map.drivable_area.end(),
                     [&](const Polygon& polygon) { return contains(polygon, point); });
}

double distanceToSegment(const Vector2& point, const Vector2& a, const Vector2& b) {
  const Vector2 span = b - a;
  const double ratio = std::clamp((point - a).dot(span) / span.squaredNorm(), 0.0, 1.0);
  return (a + ratio * span - point).norm();
}

double distanceToEdges(const LaneMap& map, const Vector2& point) {
  double least = std::numeric_limits<double>::infinity();
  const auto look = [&](const std::vector<Vector2>& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      least = std::min(least, distanceToSegment(point, ring[i], ring[(i + 1) % ring.size()]));
    }
  };
  for (const Polygon& polygon : map.drivable_area) {
    look(polygon.exterior);
    for (const auto& hole : polygon.holes) look(hole);
  }
  return least;
}

TEST(AreaRaster, AgreesWithThePolygonsAwayFromTheirEdges) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    const LaneMap map = stars(seed);
    const AreaRaster raster(map.drivable_area);
    Random random(seed + 100);
    int inside = 0;
    int outside = 0;
    for (int i = 0; i < 20000; ++i) {
      const Vector2 point = random.in(-120.0, 120.0) + Vector2(1000.0, -500.0);
      if (distanceToEdges(map, point) < kHalfCell) continue;
      const bool expected = isInside(map, point);
      (expected ? inside : outside) += 1;
      ASSERT_EQ(raster.contains(point), expected) << "seed " << seed << ", " << point.transpose();
    }
    EXPECT_GT(inside, 1000);
    EXPECT_GT(outside, 1000);
  }
}

TEST(AreaRaster, IsAccurateToHalfACell) {
  // Edges that are not on the grid of cells.
  LaneMap map;
  map.drivable_area = {rectangle(0.0, 0.0, 20.2, 10.3)};
  const AreaRaster raster(map.drivable_area);
  for (double along = 0.1; along < 10.0; along += 0.13) {
    EXPECT_TRUE(raster.contains({20.2 - 0.26, along}));
    EXPECT_FALSE(raster.contains({20.2 + 0.31, along}));
    EXPECT_TRUE(raster.contains({along, 10.3 - 0.31}));
    EXPECT_FALSE(raster.contains({along, 10.3 + 0.26}));
  }
}

TEST(AreaRaster, RespectsHolesAndUnions) {
  LaneMap map;
  map.drivable_area = {rectangle(0.0, 0.0, 40.0, 40.0)};
  map.drivable_area[0].holes = {rectangle(10.0, 10.0, 30.0, 30.0).exterior};
  const AreaRaster holed(map.drivable_area);
  EXPECT_TRUE(holed.contains({5.0, 20.0}));
  EXPECT_FALSE(holed.contains({20.0, 20.0}));
  EXPECT_TRUE(holed.contains({35.0, 20.0}));
  map.drivable_area.push_back(rectangle(18.0, 18.0, 45.0, 22.0));
  const AreaRaster bridged(map.drivable_area);
  EXPECT_TRUE(bridged.contains({20.0, 20.0})) << "another polygon covers the hole";
  EXPECT_FALSE(bridged.contains({20.0, 25.0}));
  EXPECT_TRUE(bridged.contains({35.0, 20.0})) << "where they overlap";
}

TEST(AreaRaster, NothingIsDrivableBeyondTheMap) {
  LaneMap map;
  map.drivable_area = {rectangle(-10.0, -10.0, 10.0, 10.0)};
  const AreaRaster raster(map.drivable_area);
  EXPECT_TRUE(raster.contains({9.5, 9.5}));
  for (const double far : {11.0, 21.9, 22.1, 54.5, 1e6, 1e300}) {
    for (const Vector2& direction :
         {Vector2(1.0, 0.0), Vector2(-1.0, 0.0), Vector2(0.0, 1.0), Vector2(0.0, -1.0)}) {
      EXPECT_FALSE(raster.contains(far * direction)) << far;
    }
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(raster.contains({nan, 0.0}));
  EXPECT_FALSE(raster.contains({0.0, nan}));
}

TEST(AreaRaster, IsConsistentAcrossThreads) {
  const LaneMap map = stars(3);
  const AreaRaster alone(map.drivable_area);
  const AreaRaster shared(map.drivable_area);
  std::vector<Vector2> points;
  Random random(5);
  for (int i = 0; i < 20000; ++i) points.push_back(random.in(-100.0, 100.0) + Vector2(1000, -500));
  std::vector<std::vector<char>> answers(4, std::vector<char>(points.size()));
  std::vector<std::thread> threads;
  for (std::vector<char>& own : answers) {
    threads.emplace_back([&own, &points, &shared] {
      for (std::size_t i = 0; i < points.size(); ++i) own[i] = shared.contains(points[i]);
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::vector<char>& own : answers) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      ASSERT_EQ(own[i] != 0, alone.contains(points[i])) << points[i].transpose();
    }
  }
}

TEST(AreaRaster, OfACropHasTheSameCells) {
  const LaneMap whole = stars(7);
  LaneMap part;
  part.drivable_area = {whole.drivable_area[3]};
  LaneMap wider = part;
  wider.drivable_area.push_back(rectangle(300.37, -900.11, 310.0, -890.0));
  const AreaRaster of_part(part.drivable_area);
  const AreaRaster of_wider(wider.drivable_area);
  Random random(11);
  for (int i = 0; i < 20000; ++i) {
    const Vector2 point = random.in(-110.0, 110.0) + Vector2(1000.0, -500.0);
    EXPECT_EQ(of_part.contains(point), of_wider.contains(point)) << point.transpose();
  }
}

}  // namespace
}  // namespace forge
