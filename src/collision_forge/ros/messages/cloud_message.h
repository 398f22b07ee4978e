#pragma once

#include <sensor_msgs/PointCloud2.h>

#include "collision_forge/io/lidar/point_cloud.h"

namespace forge {

/// Moves the cloud out of a message; the message's `data` are empty afterwards.
PointCloud takeCloud(sensor_msgs::PointCloud2& message);

/// Moves a cloud into a message. The header is kept.
void putCloud(PointCloud cloud, sensor_msgs::PointCloud2& message);

}  // namespace forge
