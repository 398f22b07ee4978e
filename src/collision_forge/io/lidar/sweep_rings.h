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

/// A point as the sensor saw it.
struct SeenPoint {
  Eigen::Vector3d position;  ///< m, cloud frame; as in the cloud, also without return
  float range = 0.0F;        ///< m; LidarRay::kNoReturn for a ray without return
  float azimuth = 0.0F;      ///< rad, from x to y; 0 without return
  float elevation = 0.0F;    ///< rad, above the xy plane; 0 without return
  std::int32_t ring = -1;    ///< -1: unknown
};

inline constexpr int kRingCounts[] = {16, 32, 40, 64, 128};  ///< of usual sensors

/// Returns the points of a cloud, in its order, without rings.
std::vector<SeenPoint> seenPoints(const PointCloud& cloud, const CloudLayout& layout);

/// Marks zero ranges that the correction of the ego's motion moved off the origin: a sweep that is
/// corrected to its end moves a point by the ego's motion in the rest of the sweep. Tries the
/// motions that single points suggest, and takes the one with most points.
void markMovedZeros(std::vector<SeenPoint>& seen);

/// Sets all rings by the rules of raysOf(), or leaves them at -1 if they cannot be found. Adds a
/// line to `notes` for a ring field that is ignored and for unknown rings.
void setRings(const PointCloud& cloud, const CloudLayout& layout, std::vector<SeenPoint>& seen,
              std::vector<std::string>& notes);

/// Elevations of the returns of each ring: of the far ones where it has any.
struct RingElevations {
  std::vector<double> mean;  ///< rad, by ring; NaN without returns off the ego
  double scatter = 0.0;      ///< rad, standard deviation of the far ones within the rings
  std::size_t points = 0;
};

/// Returns the elevations of points whose rings are set.
RingElevations elevationsOf(const std::vector<SeenPoint>& seen);

}  // namespace forge
