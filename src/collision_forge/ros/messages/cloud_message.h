#pragma once

#include <sensor_msgs/PointCloud2.h>

#include "collision_forge/io/lidar/point_cloud.h"

namespace forge {

/// Moves the cloud out of a message and returns it, unchecked (CloudLayout checks it); the
/// message's `data` are empty afterwards, its other fields unchanged.
PointCloud takeCloud(sensor_msgs::PointCloud2& message);

/// Moves a cloud into a message, in place of the cloud there. The message's header is kept.
void putCloud(PointCloud cloud, sensor_msgs::PointCloud2& message);

}  // namespace forge
