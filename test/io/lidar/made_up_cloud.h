#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "collision_forge/io/lidar/point_cloud.h"
#include "collision_forge/io/lidar/sweep_rays.h"

namespace forge {

/// A made-up spinning lidar and the layout of its clouds.
struct MadeUpLidar {
  int rings = 16;
  int columns = 90;
  double lowest = -0.42;      ///< rad, elevation of ring 0
  double step = 0.04;         ///< rad between rings
  bool is_organised = false;  ///< height = rings
  EmptyPoints empty = EmptyPoints::kLeftOut;
  bool is_bigendian = false;
  std::uint8_t ring_type = 4;  ///< datatype of the ring field; 0: none
  std::uint8_t time_type = 0;  ///< 7: float32, s; 6: uint32, ns; 0: none
  bool has_unknown = false;    ///< a field that nobody knows

  Eigen::Vector3d direction(int column, int ring) const;
};

/// Returns a range in a direction, m; LidarRay::kNoReturn for none.
using RangeOf = std::function<double(const Eigen::Vector3d&)>;

/// Returns the range to flat ground below a sensor at 1.8 m, up to 60 m.
double groundRangeOf(const Eigen::Vector3d& direction);

/// Returns the cloud of one turn. Intensities are 7; times run from -0.1 s to the stamp.
PointCloud madeUpCloud(const MadeUpLidar& lidar, const RangeOf& range);

}  // namespace forge
