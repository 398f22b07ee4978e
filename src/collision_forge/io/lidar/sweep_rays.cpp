#include "collision_forge/io/lidar/sweep_rays.h"

#include <algorithm>
#include <cmath>

#include "collision_forge/io/lidar/missing_rays.h"
#include "collision_forge/io/lidar/sweep_rings.h"

namespace forge {
namespace {

constexpr double kTurn = 2.0 * M_PI;
constexpr double kLongestSweep = 10.0;  // s; times of points beyond it are wrong

/// One per cent of empty points are a habit of the cloud, fewer are accidents.
EmptyPoints emptyPointsOf(const PointCloud& cloud, const std::vector<SeenPoint>& seen) {
  std::size_t zeros = 0;
  std::size_t nans = 0;
  for (const SeenPoint& point : seen) {
    if (point.range != LidarRay::kNoReturn) continue;
    ++(point.position.allFinite() ? zeros : nans);
  }
  if (zeros > nans && zeros * 100 > seen.size()) return EmptyPoints::kZero;
  if (cloud.height > 1 || nans * 100 > seen.size()) return EmptyPoints::kNan;
  return EmptyPoints::kLeftOut;
}

/// Returns true if the points come in the order of firing: organised by columns, or with the rings
/// interleaved.
bool isInFiringOrder(const std::vector<SeenPoint>& seen) {
  std::size_t changes = 0;
  for (std::size_t i = 1; i < seen.size(); ++i) {
    if (seen[i].ring != seen[i - 1].ring) ++changes;
  }
  return seen.empty() || seen.front().ring < 0 || changes * 4 > seen.size();
}

/// Returns the time of each point, s after the stamp.
std::vector<float> timesOf(const PointCloud& cloud, const CloudLayout& layout,
                           const std::vector<SeenPoint>& seen, const SweepTiming& timing) {
  std::vector<float> times(seen.size(), 0.0F);
  const bool is_ordered = isInFiringOrder(seen);
  const double columns = std::max<double>(1.0, cloud.width);
  const double count = std::max<double>(1.0, static_cast<double>(seen.size()));
  const double start = seen.empty() ? 0.0 : seen.front().azimuth;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (layout.time) {
      const double time = layout.timeOf(cloud.pointAt(i), timing.stamp);
      times[i] = std::isfinite(time)
                     ? static_cast<float>(std::clamp(time, -kLongestSweep, kLongestSweep))
                     : 0.0F;
      continue;
    }
    double share = static_cast<double>(i) / count;
    if (cloud.height > 1) share = static_cast<double>(i % cloud.width) / columns;
    // Sorted by rings: spinning lidars turn clockwise (Velodyne, Hesai, Ouster).
    if (cloud.height == 1 && !is_ordered) {
      share = std::fmod(start - seen[i].azimuth + 2.0 * kTurn, kTurn) / kTurn;
    }
    times[i] = static_cast<float>((share - 1.0) * timing.sweep_time);
  }
  return times;
}

}  // namespace

SweepRays raysOf(const PointCloud& cloud, const CloudLayout& layout, const SweepTiming& timing) {
  SweepRays sweep;
  std::vector<SeenPoint> seen = seenPoints(cloud, layout);
  if (seen.empty()) return sweep;
  markMovedZeros(seen);
  setRings(cloud, layout, seen, sweep.notes);
  const RingElevations elevations = elevationsOf(seen);
  const std::vector<float> times = timesOf(cloud, layout, seen, timing);
  sweep.empty_points = emptyPointsOf(cloud, seen);
  sweep.rays.resize(seen.size());
  for (std::size_t i = 0; i < seen.size(); ++i) {
    LidarRay& ray = sweep.rays[i];
    ray.range = seen[i].range;
    ray.ring = seen[i].ring;
    ray.time = times[i];
    ray.point = static_cast<std::uint32_t>(i);
    ray.direction.setZero();
    if (ray.range != LidarRay::kNoReturn)
      ray.direction = seen[i].position.normalized().cast<float>();
  }
  const bool has_rings =
      std::any_of(seen.begin(), seen.end(), [](const SeenPoint& point) { return point.ring >= 0; });
  const bool may_add = cloud.height == 1 && sweep.empty_points == EmptyPoints::kLeftOut;
  if (has_rings && !rebuildMissingRays(seen, elevations, may_add, sweep.rays)) {
    sweep.notes.emplace_back(
        "the azimuths have no regular step, rays without return are not rebuilt");
  }
  return sweep;
}

std::optional<double> groundBelow(const SweepRays& sweep, const Eigen::Isometry3d& pose,
                                  const Eigen::Vector2d& size) {
  constexpr double kAround = 1.5;      // m around the box
  constexpr double kReach = 1.0;       // m above and below the expected ground
  constexpr std::size_t kLeast = 6;    // points
  constexpr double kLowShare = 0.2;    // of the points are ground at least
  constexpr double kThickness = 0.15;  // m of the ground
  const Eigen::Isometry3f to_box = pose.inverse().cast<float>();
  const auto reach = static_cast<float>(size.norm() / 2.0 + 2.0 * kAround);
  const Eigen::Vector3f middle = pose.translation().cast<float>();
  std::vector<double> heights;
  for (const LidarRay& ray : sweep.rays) {
    if (ray.range == LidarRay::kNoReturn) continue;
    const Eigen::Vector3f point = ray.range * ray.direction;
    if ((point - middle).squaredNorm() > reach * reach) continue;
    const Eigen::Vector3f local = to_box * point;
    if (std::abs(local.x()) < size.x() / 2.0 + kAround &&
        std::abs(local.y()) < size.y() / 2.0 + kAround && std::abs(local.z()) < kReach) {
      heights.push_back(local.z());
    }
  }
  if (heights.size() < kLeast) return std::nullopt;
  const auto low = heights.begin() +
                   static_cast<std::ptrdiff_t>(kLowShare * static_cast<double>(heights.size()));
  std::nth_element(heights.begin(), low, heights.end());
  const double level = *low;
  double sum = 0.0;
  double count = 0.0;
  for (const double height : heights) {
    if (std::abs(height - level) > kThickness) continue;
    sum += height;
    count += 1.0;
  }
  return sum / count;
}

}  // namespace forge
