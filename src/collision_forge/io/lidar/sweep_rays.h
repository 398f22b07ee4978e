#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/io/lidar/lidar_ray.h"
#include "collision_forge/io/lidar/point_cloud.h"

namespace forge {

/// How a cloud holds the rays without return.
enum class EmptyPoints {
  kLeftOut,
  kZero,  ///< as points at (or, after a correction of the ego's motion, near) the origin
  kNan,
};

/// The rays of a sweep: first one per point, in the cloud's order, then the missing ones.
struct SweepRays {
  std::vector<LidarRay> rays;
  EmptyPoints empty_points = EmptyPoints::kLeftOut;
  std::vector<std::string> notes;  ///< what could not be reconstructed, one line each
};

/// How to read a sweep.
struct SweepTiming {
  double stamp = 0.0;       ///< s, the cloud's
  double sweep_time = 0.0;  ///< s, LidarOptions::sweep_time
};

/// Returns the rays of a cloud of a spinning lidar. The ray of a point with a return is exact: the
/// direction to the point. Rays without return are reconstructed from the rays before and after
/// them in their ring: where the cloud has a point for them (NaN, zero range, or, in clouds whose
/// ego motion was corrected, zero range moved by that motion), and else, in unorganised clouds, in
/// gaps of the ring's azimuths. Evenly spaced rings without any return are added up to the next
/// usual number of rings, 16 to 128. Rings come from the ring field if the elevations agree with
/// it, else from the order of the points, else from the elevations of a VLP-16 or HDL-32E. Times
/// come from the time field, else from the place in the sweep, which ends at the stamp.
SweepRays raysOf(const PointCloud& cloud, const CloudLayout& layout, const SweepTiming& timing);

/// Returns the height of the ground above the xy plane of the frame `pose` (in the cloud's frame),
/// m, from the points below and around a box of length and width `size`; nullopt with too few
/// points within 1 m of that plane.
std::optional<double> groundBelow(const SweepRays& sweep, const Eigen::Isometry3d& pose,
                                  const Eigen::Vector2d& size);

}  // namespace forge
