#include "collision_forge/io/lidar/sweep_rings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace forge {
namespace {

constexpr float kZeroRange = 0.05F;     // m; nearer points are rays without return
constexpr float kOwnVehicle = 1.0F;     // m; nearer points may be zero ranges moved by the ego
constexpr float kFar = 5.0F;            // m; from here on, corrected ego motion bends no ray much
constexpr double kRingScatter = 0.026;  // rad, of the elevations within a ring
constexpr int kMaxRings = 512;

/// A table of evenly spaced elevations (ros-drivers/velodyne, params/VLP16db.yaml, 32db.yaml).
struct ElevationTable {
  int rings;
  double lowest, step;  ///< degrees
};
constexpr ElevationTable kTables[] = {{16, -15.0, 2.0}, {32, -30.67, 4.0 / 3.0}};

bool areRings(const RingElevations& elevations) {
  return elevations.points > 0 && elevations.scatter < kRingScatter;
}

bool setRingsFromField(const PointCloud& cloud, const CloudLayout& layout,
                       std::vector<SeenPoint>& seen) {
  if (!layout.ring) return false;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const double ring = layout.ring->get(cloud.pointAt(i));
    if (!(ring >= 0.0 && ring < kMaxRings)) return false;
    seen[i].ring = static_cast<std::int32_t>(ring);
  }
  return areRings(elevationsOf(seen));
}

/// Rings of clouds whose points come column by column, one per ring.
bool setRingsFromOrder(std::vector<SeenPoint>& seen) {
  for (const int rings : kRingCounts) {
    if (seen.empty() || seen.size() % static_cast<std::size_t>(rings) != 0) continue;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      seen[i].ring = static_cast<std::int32_t>(i % static_cast<std::size_t>(rings));
    }
    if (areRings(elevationsOf(seen))) return true;
  }
  return false;
}

bool setRingsFromElevation(std::vector<SeenPoint>& seen) {
  constexpr double kLeastFitting = 0.9;  // share of the far points within a quarter of a step
  for (const ElevationTable& table : kTables) {
    std::size_t fitting = 0;
    std::size_t far = 0;
    for (SeenPoint& point : seen) {
      point.ring = -1;
      if (point.range == LidarRay::kNoReturn) continue;
      const double place = (point.elevation * 180.0 / M_PI - table.lowest) / table.step;
      const double nearest = std::round(place);
      if (nearest >= 0 && nearest < table.rings) point.ring = static_cast<std::int32_t>(nearest);
      if (point.range < kFar) continue;
      ++far;
      if (point.ring >= 0 && std::abs(place - nearest) < 0.25) ++fitting;
    }
    if (far > 0 && static_cast<double>(fitting) >= kLeastFitting * static_cast<double>(far))
      return true;
  }
  return false;
}

}  // namespace

std::vector<SeenPoint> seenPoints(const PointCloud& cloud, const CloudLayout& layout) {
  std::vector<SeenPoint> seen(cloud.pointCount());
  for (std::size_t i = 0; i < seen.size(); ++i) {
    SeenPoint& point = seen[i];
    point.position = layout.position(cloud.pointAt(i));
    const double range = point.position.norm();
    const bool is_return = std::isfinite(range) && range >= kZeroRange;
    point.range = is_return ? static_cast<float>(range) : LidarRay::kNoReturn;
    if (!is_return) continue;
    const auto flat = point.position.cast<float>();
    point.azimuth = std::atan2(flat.y(), flat.x());
    point.elevation = std::atan2(flat.z(), std::hypot(flat.x(), flat.y()));
  }
  return seen;
}

void markMovedZeros(std::vector<SeenPoint>& seen) {
  constexpr std::size_t kTries = 64;
  constexpr float kNear = 0.03F;         // m
  constexpr float kLastShare = 0.1F;     // of the sweep, in which motion and noise are alike
  constexpr std::size_t kLeastOf = 200;  // one point of so many must agree
  std::vector<std::uint32_t> near;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i].range < kOwnVehicle) near.push_back(static_cast<std::uint32_t>(i));
  }
  const auto rest = [&](std::uint32_t i) {
    return 1.0F - static_cast<float>(i) / static_cast<float>(seen.size());
  };
  const auto isMoved = [&](std::uint32_t i, const Eigen::Vector3f& motion) {
    return (seen[i].position.cast<float>() - rest(i) * motion).squaredNorm() < kNear * kNear;
  };
  std::size_t most = seen.size() / kLeastOf;
  std::optional<Eigen::Vector3f> best;
  for (std::size_t k = 0; k < std::min(kTries, near.size()); ++k) {
    const std::uint32_t i = near[k * near.size() / std::min(kTries, near.size())];
    if (rest(i) < kLastShare) continue;
    const Eigen::Vector3f motion = seen[i].position.cast<float>() / rest(i);
    const auto count = static_cast<std::size_t>(std::count_if(
        near.begin(), near.end(), [&](std::uint32_t point) { return isMoved(point, motion); }));
    if (count <= most) continue;
    most = count;
    best = motion;
    if (most > near.size() / 2) break;
  }
  if (!best) return;
  for (const std::uint32_t i : near) {
    if (isMoved(i, *best)) seen[i].range = LidarRay::kNoReturn;
  }
}

void setRings(const PointCloud& cloud, const CloudLayout& layout, std::vector<SeenPoint>& seen,
              std::vector<std::string>& notes) {
  if (setRingsFromField(cloud, layout, seen)) return;
  if (layout.ring)
    notes.emplace_back("the ring field does not follow the elevation and is ignored");
  if (setRingsFromOrder(seen) || setRingsFromElevation(seen)) return;
  for (SeenPoint& point : seen) point.ring = -1;
  notes.emplace_back("rings are unknown, rays without return are not rebuilt");
}

RingElevations elevationsOf(const std::vector<SeenPoint>& seen) {
  std::vector<double> sum(kMaxRings, 0.0);
  std::vector<double> square(kMaxRings, 0.0);
  std::vector<std::size_t> count(kMaxRings, 0);
  std::vector<double> near_sum(kMaxRings, 0.0);
  std::vector<double> near_count(kMaxRings, 0.0);
  for (const SeenPoint& point : seen) {
    if (point.ring < 0 || point.range < kOwnVehicle || point.range == LidarRay::kNoReturn) continue;
    if (point.range < kFar) {
      near_sum[point.ring] += point.elevation;
      near_count[point.ring] += 1.0;
      continue;
    }
    sum[point.ring] += point.elevation;
    square[point.ring] += double{point.elevation} * point.elevation;
    ++count[point.ring];
  }
  RingElevations elevations;
  elevations.mean.assign(kMaxRings, std::numeric_limits<double>::quiet_NaN());
  double scatter = 0.0;
  for (int ring = 0; ring < kMaxRings; ++ring) {
    if (count[ring] == 0) {
      if (near_count[ring] > 0.0) elevations.mean[ring] = near_sum[ring] / near_count[ring];
      continue;
    }
    const auto points = static_cast<double>(count[ring]);
    elevations.mean[ring] = sum[ring] / points;
    scatter += square[ring] - sum[ring] * sum[ring] / points;
    elevations.points += count[ring];
  }
  if (elevations.points > 0) {
    elevations.scatter = std::sqrt(std::max(0.0, scatter / static_cast<double>(elevations.points)));
  }
  return elevations;
}

}  // namespace forge
