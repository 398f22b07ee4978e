#pragma once

#include <cstdint>
#include <map>
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
  Eigen::VectorXd recorded_features;  ///< featuresOf() the recorded points
  Eigen::VectorXd injected_features;  ///< featuresOf() the injected points
};

/// The points of one vehicle in a sweep.
struct VehiclePoints {
  std::vector<Eigen::Vector3d> positions;  ///< m, in the frame of the box
  std::vector<double> ranges;              ///< m from the sensor
  std::vector<double> azimuths;            ///< rad, in the cloud's frame
  std::map<int, std::size_t> rings;        ///< number of points by ring
  std::vector<double> intensities;
};

/// Names of the elements of featuresOf().
inline constexpr const char* kPointFeatures[] = {"logarithm of the number",
                                                 "rings",
                                                 "share of rings left out",
                                                 "width",
                                                 "height",
                                                 "middle height",
                                                 "depth",
                                                 "mean intensity",
                                                 "spread of intensity"};

/// Returns simple features of a vehicle's points, in the order of kPointFeatures: natural logarithm
/// of their number + 1; number of rings; share of the rings between the lowest and the highest one
/// that have no point; extent in azimuth times mean range, m; extent and mean of the height, m;
/// standard deviation of the range, m; mean and standard deviation of the intensity. Zeros without
/// points.
Eigen::VectorXd featuresOf(const VehiclePoints& points);

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
