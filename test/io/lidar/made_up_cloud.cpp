#include "io/lidar/made_up_cloud.h"

#include <cmath>
#include <limits>
#include <string>

namespace forge {

Eigen::Vector3d MadeUpLidar::direction(int column, int ring) const {
  const double azimuth = 3.0 - 2.0 * M_PI * column / columns;
  const double elevation = lowest + step * ring;
  return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
          std::sin(elevation)};
}

double groundRangeOf(const Eigen::Vector3d& direction) {
  const double range = direction.z() < 0.0 ? -1.8 / direction.z() : LidarRay::kNoReturn;
  return range < 60.0 ? range : LidarRay::kNoReturn;
}

PointCloud madeUpCloud(const MadeUpLidar& lidar, const RangeOf& range) {
  PointCloud cloud;
  cloud.is_bigendian = lidar.is_bigendian;
  const auto addField = [&](const std::string& name, std::uint8_t type, std::uint32_t size) {
    cloud.fields.push_back({name, cloud.point_step, type, 1});
    cloud.point_step += size;
  };
  if (lidar.has_unknown) addField("echo_width", 2, 3);  // two bytes of padding
  for (const char* name : {"x", "y", "z", "intensity"}) addField(name, 7, 4);
  if (lidar.ring_type != 0) addField("ring", lidar.ring_type, 4);
  if (lidar.time_type != 0) addField("time", lidar.time_type, 4);
  const auto write = [&](std::uint8_t* point, int column, int ring) {
    const CloudLayout layout(cloud);
    const Eigen::Vector3d direction = lidar.direction(column, ring);
    const double distance = range(direction);
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    Eigen::Vector3d position = distance * direction;
    if (!std::isfinite(distance)) {
      position.setConstant(lidar.empty == EmptyPoints::kZero ? 0.0 : kNan);
    }
    layout.setPosition(point, position);
    layout.intensity->set(point, 7.0);
    if (layout.ring) layout.ring->set(point, ring);
    const double time = 0.1 * column / lidar.columns;
    if (layout.time) layout.time->set(point, lidar.time_type == 7 ? time - 0.1 : time * 1e9);
    if (lidar.has_unknown) point[0] = static_cast<std::uint8_t>(7 * column + ring);
  };
  std::vector<std::uint8_t> point(cloud.point_step);
  const auto add = [&](int column, int ring) {
    if (!std::isfinite(range(lidar.direction(column, ring))) &&
        lidar.empty == EmptyPoints::kLeftOut) {
      return;
    }
    write(point.data(), column, ring);
    cloud.data.insert(cloud.data.end(), point.begin(), point.end());
  };
  if (lidar.is_organised) {
    for (int ring = 0; ring < lidar.rings; ++ring) {
      for (int column = 0; column < lidar.columns; ++column) add(column, ring);
    }
  } else {
    for (int column = 0; column < lidar.columns; ++column) {
      for (int ring = 0; ring < lidar.rings; ++ring) add(column, ring);
    }
  }
  cloud.height = lidar.is_organised ? static_cast<std::uint32_t>(lidar.rings) : 1;
  cloud.width = static_cast<std::uint32_t>(cloud.data.size() / cloud.point_step / cloud.height);
  cloud.row_step = cloud.width * cloud.point_step;
  cloud.is_dense = lidar.empty != EmptyPoints::kNan;
  return cloud;
}

}  // namespace forge
