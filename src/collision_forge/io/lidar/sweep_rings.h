#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "collision_forge/io/lidar/lidar_ray.h"
#include "collision_forge/io/lidar/point_cloud.h"

/// Steps of raysOf(): the points of a sweep as the sensor saw them, and their rings.
namespace forge {

/// A point as the sensor saw it, in spherical coordinates around the sensor.
struct SeenPoint {
  Eigen::Vector3d position;  ///< m, cloud frame; as in the cloud, also without return
  float range = 0.0F;        ///< m; LidarRay::kNoReturn for a ray without return
  float azimuth = 0.0F;      ///< rad, from x to y; 0 without return
  float elevation = 0.0F;    ///< rad, above the xy plane; 0 without return
  std::int32_t ring = -1;    ///< index of the laser; -1: unknown
};

/// Numbers of rings of usual sensors, ascending.
inline constexpr int kRingCounts[] = {16, 32, 40, 64, 128};

/// Returns the points of a cloud, in its order, without rings. Points with NaN coordinates or
/// nearer than 0.05 m are rays without return.
std::vector<SeenPoint> seenPoints(const PointCloud& cloud, const CloudLayout& layout);

/// Sets `range` to LidarRay::kNoReturn for zero ranges that the correction of the ego's motion
/// moved off the origin: a sweep that is corrected to its end moves a point by the ego's motion in
/// the rest of the sweep. `seen` must be in the order of firing. Tries the motions that single
/// points nearer than 1 m suggest, and takes the motion with which most points agree; changes
/// nothing if at most one point in 200 agrees.
void markMovedZeros(std::vector<SeenPoint>& seen);

/// Sets all rings by the rules of raysOf(), or leaves them at -1 if they cannot be found. Adds a
/// line to `notes` for a ring field that is ignored and for unknown rings.
void setRings(const PointCloud& cloud, const CloudLayout& layout, std::vector<SeenPoint>& seen,
              std::vector<std::string>& notes);

/// Elevations of the returns of each ring. Returns from 5 m on (far ones) are used; a ring without
/// far returns uses its returns from 1 m on.
struct RingElevations {
  /// rad, by ring, 512 elements; NaN for a ring without returns from 1 m on.
  std::vector<double> mean;
  double scatter = 0.0;    ///< rad, standard deviation of the far returns around the mean of their
                           ///< ring; 0 without far returns
  std::size_t points = 0;  ///< number of far returns
};

/// Returns the elevations of points whose rings are set, each below 512; points with ring -1 are
/// ignored.
RingElevations elevationsOf(const std::vector<SeenPoint>& seen);

}  // namespace forge
