#include "collision_forge/ros/messages/cloud_message.h"

#include <utility>

namespace forge {

PointCloud takeCloud(sensor_msgs::PointCloud2& message) {
  PointCloud cloud;
  cloud.height = message.height;
  cloud.width = message.width;
  for (const sensor_msgs::PointField& field : message.fields) {
    cloud.fields.push_back({field.name, field.offset, field.datatype, field.count});
  }
  cloud.is_bigendian = message.is_bigendian != 0;
  cloud.point_step = message.point_step;
  cloud.row_step = message.row_step;
  cloud.data.swap(message.data);
  cloud.is_dense = message.is_dense != 0;
  return cloud;
}

void putCloud(PointCloud cloud, sensor_msgs::PointCloud2& message) {
  message.height = cloud.height;
  message.width = cloud.width;
  message.fields.clear();
  for (const CloudField& field : cloud.fields) {
    sensor_msgs::PointField& added = message.fields.emplace_back();
    added.name = field.name;
    added.offset = field.offset;
    added.datatype = field.datatype;
    added.count = field.count;
  }
  message.is_bigendian = cloud.is_bigendian ? 1 : 0;
  message.point_step = cloud.point_step;
  message.row_step = cloud.row_step;
  message.data = std::move(cloud.data);
  message.is_dense = cloud.is_dense ? 1 : 0;
}

}  // namespace forge
