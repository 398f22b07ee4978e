#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "collision_forge/io/lidar/cloud_injection.h"

namespace forge {

/// A recorded vehicle in a cloud.
struct VehicleInCloud {
  std::string id;
  AgentClass agent_class = AgentClass::kCar;
  Eigen::Isometry3d pose;  ///< in the cloud's frame; origin at the bottom of the box
  Eigen::Vector3d size;    ///< length, width, height, m
};

/// A recorded vehicle compared with the body that replaced it. Points: of the box and 0.1 m around
/// it, from 0.2 m above the ground on.
struct ReplacedVehicle {
  std::string id;
  AgentClass agent_class = AgentClass::kCar;
  double range = 0.0;           ///< m, to the middle of the box
  std::size_t recorded = 0;     ///< points
  std::size_t injected = 0;     ///< points
  double ring_overlap = 0.0;    ///< 0..1, shared part of the two histograms over the rings
  double recorded_share = 0.0;  ///< of the rays that meet the body: recorded returns in the box
  double injected_share = 0.0;  ///< the same after the replacement
  double distance = 0.0;        ///< m, Chamfer distance of recorded and injected points
  double floor = 0.0;           ///< m, the same of recorded points among themselves
  double recorded_brightness = 0.0;  ///< median intensity
  double injected_brightness = 0.0;
};

/// How vehicles are replaced.
struct ReplacementOptions {
  std::size_t least_points = 20;  ///< vehicles with fewer recorded points are left out
  double range_noise = 0.0;       ///< m
  std::uint64_t seed = 0;
};

/// Takes each vehicle out of the cloud and puts a body of its box in its place, one at a time.
/// Returns of the body are drawn by what the other vehicles of the cloud return. Distances are
/// between every second recorded point and every second point of the other kind, so that both have
/// the same number of samples: the mean over both directions of the distance to the nearest.
std::vector<ReplacedVehicle> replaceVehicles(const PointCloud& cloud, const SweepTiming& timing,
                                             const std::vector<VehicleInCloud>& vehicles,
                                             const ReplacementOptions& options);

}  // namespace forge
