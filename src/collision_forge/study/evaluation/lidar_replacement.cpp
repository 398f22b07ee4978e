#include "collision_forge/study/evaluation/lidar_replacement.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace forge {
namespace {

constexpr double kAroundBox = 0.1;    // m
constexpr double kAboveGround = 0.2;  // m

PosedBody bodyOf(const VehicleInCloud& vehicle, double ground) {
  PosedBody posed;
  Eigen::Vector3d size = vehicle.size;
  size.z() -= ground;  // from the ground to the top of the box
  posed.body = lidarBodyOf(vehicle.agent_class, size);
  posed.begin = vehicle.pose * Eigen::Translation3d(0.0, 0.0, ground);
  posed.end = posed.begin;
  return posed;
}

VehiclePoints pointsOf(const PosedBody& posed, const PointCloud& cloud, const CloudLayout& layout,
                       const SweepRays& sweep) {
  VehiclePoints points;
  const Eigen::Isometry3d to_box = posed.end.inverse();
  for (const LidarRay& ray : sweep.rays) {
    if (ray.range == LidarRay::kNoReturn) continue;
    const Eigen::Vector3d local = to_box * (ray.range * ray.direction).cast<double>();
    if (std::abs(local.x()) > posed.body.size.x() / 2.0 + kAroundBox ||
        std::abs(local.y()) > posed.body.size.y() / 2.0 + kAroundBox || local.z() < kAboveGround ||
        local.z() > posed.body.size.z() + kAroundBox) {
      continue;
    }
    points.positions.push_back(local);
    points.ranges.push_back(ray.range);
    points.azimuths.push_back(std::atan2(ray.direction.y(), ray.direction.x()));
    ++points.rings[ray.ring];
    if (layout.intensity) {
      points.intensities.push_back(layout.intensity->get(cloud.pointAt(ray.point)));
    }
  }
  return points;
}

double medianOf(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::vector<Eigen::Vector3d> everySecond(const std::vector<Eigen::Vector3d>& points,
                                         std::size_t first) {
  std::vector<Eigen::Vector3d> half;
  for (std::size_t i = first; i < points.size(); i += 2) half.push_back(points[i]);
  return half;
}

double meanToNearest(const std::vector<Eigen::Vector3d>& from,
                     const std::vector<Eigen::Vector3d>& to) {
  double sum = 0.0;
  for (const Eigen::Vector3d& point : from) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& other : to)
      nearest = std::min(nearest, (point - other).squaredNorm());
    sum += std::sqrt(nearest);
  }
  return sum / static_cast<double>(from.size());
}

double chamfer(const std::vector<Eigen::Vector3d>& a, const std::vector<Eigen::Vector3d>& b) {
  if (a.empty() || b.empty()) return std::numeric_limits<double>::infinity();
  return (meanToNearest(a, b) + meanToNearest(b, a)) / 2.0;
}

double overlapOf(const VehiclePoints& a, const VehiclePoints& b) {
  double overlap = 0.0;
  for (const auto& [ring, count] : a.rings) {
    const auto found = b.rings.find(ring);
    if (found == b.rings.end()) continue;
    overlap +=
        std::min(static_cast<double>(count) / static_cast<double>(a.positions.size()),
                 static_cast<double>(found->second) / static_cast<double>(b.positions.size()));
  }
  return overlap;
}

std::size_t raysOn(const PosedBody& posed, const SweepRays& sweep) {
  const RayWindow window = posed.window();
  return static_cast<std::size_t>(
      std::count_if(sweep.rays.begin(), sweep.rays.end(), [&](const LidarRay& ray) {
        return !ray.direction.isZero() && window.contains(ray.direction) && posed.hitOf(ray);
      }));
}

struct MeanAndDeviation {
  double mean = 0.0;
  double deviation = 0.0;
};

MeanAndDeviation meanOf(const std::vector<double>& values) {
  if (values.empty()) return {};
  const Eigen::Map<const Eigen::ArrayXd> all(values.data(),
                                             static_cast<Eigen::Index>(values.size()));
  return {all.mean(), std::sqrt((all - all.mean()).square().mean())};
}

/// Returns the angle that azimuths cover, seen from the first one, rad.
double extentOf(const std::vector<double>& azimuths) {
  double low = 0.0;
  double high = 0.0;
  for (const double azimuth : azimuths) {
    const double turned = std::remainder(azimuth - azimuths.front(), 2.0 * M_PI);
    low = std::min(low, turned);
    high = std::max(high, turned);
  }
  return high - low;
}

}  // namespace

Eigen::VectorXd featuresOf(const VehiclePoints& points) {
  Eigen::VectorXd features =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(std::size(kPointFeatures)));
  if (points.positions.empty()) return features;
  std::vector<double> heights;
  for (const Eigen::Vector3d& position : points.positions) heights.push_back(position.z());
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  const auto rings = static_cast<double>(points.rings.size());
  const double between = points.rings.rbegin()->first - points.rings.begin()->first + 1.0;
  const MeanAndDeviation range = meanOf(points.ranges);
  const MeanAndDeviation intensity = meanOf(points.intensities);
  features << std::log1p(static_cast<double>(heights.size())), rings, 1.0 - rings / between,
      range.mean * extentOf(points.azimuths), *high - *low, meanOf(heights).mean, range.deviation,
      intensity.mean, intensity.deviation;
  return features;
}

std::vector<ReplacedVehicle> replaceVehicles(const PointCloud& cloud, const SweepTiming& timing,
                                             const std::vector<VehicleInCloud>& vehicles,
                                             const ReplacementOptions& options) {
  const CloudLayout layout(cloud);
  const SweepRays sweep = raysOf(cloud, layout, timing);
  std::vector<PosedBody> bodies;
  for (const VehicleInCloud& vehicle : vehicles) {
    bodies.push_back(
        bodyOf(vehicle, groundBelow(sweep, vehicle.pose, vehicle.size.head<2>()).value_or(0.0)));
  }
  std::vector<ReplacedVehicle> replaced;
  for (std::size_t i = 0; i < vehicles.size(); ++i) {
    const PosedBody& posed = bodies[i];
    bodies[i].brightness = brightnessOf(vehicles[i].id, options.seed);
    const VehiclePoints recorded = pointsOf(posed, cloud, layout, sweep);
    if (recorded.positions.size() < options.least_points) continue;
    SurfaceReturns surfaces;
    std::vector<PosedBody> others = bodies;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    surfaces.learn(cloud, layout, sweep, others);
    PointCloud edited = cloud;
    editCloud(edited, layout, sweep,
              {{posed}, {{posed.end, posed.body.size}}, nullptr, options.range_noise, options.seed},
              surfaces);
    const VehiclePoints injected = pointsOf(posed, edited, layout, raysOf(edited, layout, timing));
    ReplacedVehicle result;
    result.id = vehicles[i].id;
    result.agent_class = vehicles[i].agent_class;
    result.range = posed.end.translation().norm();
    result.recorded = recorded.positions.size();
    result.injected = injected.positions.size();
    result.ring_overlap = overlapOf(recorded, injected);
    const auto rays = static_cast<double>(std::max<std::size_t>(1, raysOn(posed, sweep)));
    result.recorded_share = static_cast<double>(result.recorded) / rays;
    result.injected_share = static_cast<double>(result.injected) / rays;
    const auto sample = everySecond(recorded.positions, 0);
    result.floor = chamfer(sample, everySecond(recorded.positions, 1));
    result.distance = chamfer(sample, everySecond(injected.positions, 1));
    result.recorded_brightness = medianOf(recorded.intensities);
    result.injected_brightness = medianOf(injected.intensities);
    result.recorded_features = featuresOf(recorded);
    result.injected_features = featuresOf(injected);
    replaced.push_back(result);
  }
  return replaced;
}

}  // namespace forge
