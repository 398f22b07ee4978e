#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "collision_forge/io/lidar/cloud_injection.h"

namespace forge {

/// A recorded vehicle in a cloud.
struct VehicleInCloud {
  std::string id;  ///< agent id
  AgentClass agent_class = AgentClass::kCar;
  /// Pose in the cloud's frame; origin in the middle of the bottom of the box, x ahead.
  Eigen::Isometry3d pose;
  Eigen::Vector3d size;  ///< length, width, height, m
};

/// A recorded vehicle compared with the body that replaced it. "Points" are the returns in the
/// vehicle's box and up to 0.1 m beside and above it, from 0.2 m above the ground on. "Recorded" is
/// the original cloud, "injected" the cloud with the body.
struct ReplacedVehicle {
  std::string id;  ///< VehicleInCloud::id
  AgentClass agent_class = AgentClass::kCar;
  double range = 0.0;  ///< m from the cloud's origin to the ground below the middle of the box
  std::size_t recorded = 0;   ///< number of recorded points
  std::size_t injected = 0;   ///< number of injected points
  double ring_overlap = 0.0;  ///< 0..1, intersection of the normalised histograms of recorded and
                              ///< injected points over the rings of the lidar; 1: equal, 0 without
                              ///< injected points
  /// Recorded points over the number of rays that meet the body (taken as 1 if there are none); may
  /// exceed 1.
  double recorded_share = 0.0;
  double injected_share = 0.0;  ///< injected points over the same number of rays
  double distance = 0.0;  ///< m, Chamfer distance of recorded and injected points; infinite with
                          ///< fewer than two injected points
  double floor = 0.0;  ///< m, Chamfer distance of the two halves of the recorded points: the best
                       ///< possible `distance`
  double recorded_brightness = 0.0;   ///< median intensity of the recorded points, in the cloud's
                                      ///< unit; 0 without points or without an intensity field
  double injected_brightness = 0.0;   ///< the same of the injected points
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
  double range_noise = 0.0;       ///< m, standard deviation of the range of the body's returns
  std::uint64_t seed = 0;         ///< seed of all random draws
};

/// Takes each vehicle out of the cloud and puts a body of its box in its place, one at a time from
/// the original cloud, and compares both. `timing`: the times of the cloud's rays. Returns one
/// element per vehicle with at least `least_points` recorded points, in the order of `vehicles`.
/// Return and intensity of each ray that meets the body are drawn from the returns of the other
/// vehicles in the cloud. The Chamfer distances compare every second recorded point with every
/// second point of the other kind, so that `distance` and `floor` use equally many recorded
/// samples: the mean over both directions of the mean distance to the nearest point.
std::vector<ReplacedVehicle> replaceVehicles(const PointCloud& cloud, const SweepTiming& timing,
                                             const std::vector<VehicleInCloud>& vehicles,
                                             const ReplacementOptions& options);

}  // namespace forge
