#include "collision_forge/io/lidar/background_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace forge {
namespace {

constexpr double kCell = 1.0;         // m, of the ground
constexpr double kCube = 0.25;        // m, of obstacles
constexpr double kObstacle = 0.35;    // m above the ground of its cell
constexpr double kBelowSensor = 0.5;  // m; higher cells hold leaves or signs, no ground
constexpr double kMargin = 0.3;       // m around movers
constexpr double kReach = 80.0;       // m
constexpr double kStep = 0.1;         // m along a ray

std::uint64_t keyOf(double x, double y, double z, double size) {
  constexpr std::int64_t kMiddle = 1 << 20;  // so that no part is negative
  const auto part = [size](double value) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(value / size)) +
                                      kMiddle) &
           0x1FFFFF;
  };
  return part(x) << 42 | part(y) << 21 | part(z);
}
std::uint64_t cellOf(const Eigen::Vector3d& point) {
  return keyOf(point.x(), point.y(), 0.0, kCell);
}
std::uint64_t cubeOf(const Eigen::Vector3d& point) {
  return keyOf(point.x(), point.y(), point.z(), kCube);
}

}  // namespace

void BackgroundMap::add(const PointCloud& cloud, const CloudLayout& layout, const SweepRays& sweep,
                        const Eigen::Isometry3d& sensor, const std::vector<VacatedBox>& movers) {
  constexpr float kNearest = 2.5F;  // m; nearer returns are the ego's own
  for (const LidarRay& ray : sweep.rays) {
    if (ray.range == LidarRay::kNoReturn || ray.range < kNearest || ray.range > kReach) continue;
    const Eigen::Vector3d point = sensor * (ray.range * ray.direction).cast<double>();
    constexpr double kLowest = -std::numeric_limits<double>::infinity();
    const bool is_mover = std::any_of(movers.begin(), movers.end(), [&](const VacatedBox& box) {
      return box.contains(point, ray.time, kMargin, kLowest);
    });
    if (is_mover) continue;
    const auto intensity = static_cast<float>(
        layout.intensity ? layout.intensity->get(cloud.pointAt(ray.point)) : 0.0);
    const auto height = static_cast<float>(point.z());
    const auto [cell, is_new] = ground_.try_emplace(cellOf(point), Cell{height, intensity});
    if (!is_new && height < cell->second.height) cell->second = {height, intensity};
    obstacles_.try_emplace(cubeOf(point), intensity);
  }
}

void BackgroundMap::finish() {
  std::unordered_map<std::uint64_t, Cell> lowest;
  for (const auto& [key, cell] : ground_) {
    constexpr std::int64_t kAround = 2;  // cells
    for (std::int64_t x = -kAround; x <= kAround; ++x) {
      for (std::int64_t y = -kAround; y <= kAround; ++y) {
        const std::uint64_t near =
            key + (static_cast<std::uint64_t>(x) << 42) + (static_cast<std::uint64_t>(y) << 21);
        const auto [place, is_new] = lowest.try_emplace(near, cell);
        if (!is_new && std::pair(cell.height, cell.intensity) <
                           std::pair(place->second.height, place->second.intensity)) {
          place->second = cell;
        }
      }
    }
  }
  ground_ = std::move(lowest);
}

float BackgroundMap::rangeFrom(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                               double begin, double& intensity) const {
  for (double range = begin; range < kReach; range += kStep) {
    const Eigen::Vector3d point = origin + range * direction;
    const auto ground = ground_.find(cellOf(point));
    if (ground == ground_.end() || ground->second.height > origin.z() - kBelowSensor) continue;
    const double above = point.z() - ground->second.height;
    if (above <= 0.0) {
      intensity = ground->second.intensity;
      const double back = direction.z() < 0.0 ? std::min(kStep, above / direction.z()) : 0.0;
      return static_cast<float>(range - back);
    }
    if (above < kObstacle) continue;
    const auto obstacle = obstacles_.find(cubeOf(point));
    if (obstacle == obstacles_.end()) continue;
    intensity = obstacle->second;
    return static_cast<float>(range);
  }
  return LidarRay::kNoReturn;
}

float BackgroundOfSensor::rangeBehind(const LidarRay& ray, double& intensity) const {
  const Eigen::Vector3d direction = sensor_.linear() * ray.direction.cast<double>().normalized();
  return map_.rangeFrom(sensor_.translation(), direction, double{ray.range} + kStep, intensity);
}

}  // namespace forge
