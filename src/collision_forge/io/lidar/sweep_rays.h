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
  kLeftOut,  ///< no points
  kZero,     ///< as points at (or, after a correction of the ego's motion, near) the origin
  kNan,      ///< points with NaN coordinates
};

/// The rays of a sweep: first one per point, in the cloud's order, then, ring by ring, the rays for
/// which the cloud has no point.
struct SweepRays {
  std::vector<LidarRay> rays;  ///< the first pointCount() ones belong to the points
  /// kZero or kNan from 1 % of such points on; kNan for any organised cloud that is not kZero.
  EmptyPoints empty_points = EmptyPoints::kLeftOut;
  /// Messages for the user: what could not be reconstructed; empty: no problem.
  std::vector<std::string> notes;
};

/// How to read a sweep.
struct SweepTiming {
  double stamp = 0.0;       ///< s, the stamp in the cloud's header
  double sweep_time = 0.0;  ///< s, LidarOptions::sweep_time; used for clouds without a time field
};

/// Returns the rays of a cloud of a spinning lidar. The ray of a point with a return is exact: the
/// direction to the point. Rays without return are reconstructed from the rays before and after
/// them in their ring: where the cloud has a point for them (NaN, zero range, or, in clouds whose
/// ego motion was corrected, zero range moved by that motion), and else, in unorganised clouds, in
/// gaps of the ring's azimuths. Evenly spaced rings without any return are added up to the next
/// usual number of rings, 16 to 128. Rings come from the ring field if the elevations agree with
/// it, else from the order of the points, else from the elevations of a VLP-16 or HDL-32E. Times
/// come from the time field, else from the place in the sweep, which ends at the stamp. Times from
/// the time field are clamped to 10 s around the stamp. If rings or azimuth steps cannot be found,
/// rays without return are not rebuilt, which is reported in `notes`, and their directions are
/// zero. A cloud without points gives no rays.
SweepRays raysOf(const PointCloud& cloud, const CloudLayout& layout, const SweepTiming& timing);

/// Returns the height of the ground above the xy plane of the frame `pose` (in the cloud's frame;
/// origin below the box's middle), m, from the returns within 1 m of that plane below and up to 1.5
/// m around a box of length and width `size` (m): the mean of the points within 0.15 m of the 20 %
/// quantile of height. Returns nullopt with fewer than 6 points.
std::optional<double> groundBelow(const SweepRays& sweep, const Eigen::Isometry3d& pose,
                                  const Eigen::Vector2d& size);

}  // namespace forge
