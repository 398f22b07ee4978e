#include <sensor_msgs/PointCloud2.h>

#include "collision_forge/io/lidar/cloud_injection.h"
#include "collision_forge/ros/messages/cloud_message.h"
#include "fuzz/message_in.h"
#include "fuzz/reading.h"
#include "fuzz/targets.h"

namespace forge {
namespace {

PosedBody carAhead() {
  PosedBody car;
  car.body = lidarBodyOf(AgentClass::kCar, {4.5, 1.9, 1.5});
  car.end = Eigen::Isometry3d(Eigen::Translation3d(8.0, 0.0, -1.8));
  car.begin = car.end;
  return car;
}

}  // namespace

/// Input: a serialised sensor_msgs/PointCloud2; a car is put into it.
bool fuzzClouds(const std::string& input) {
  return isTaken("", [&] {
    auto message = messageIn<sensor_msgs::PointCloud2>(input);
    PointCloud cloud = takeCloud(message);
    const CloudLayout layout(cloud);
    const SweepRays sweep = raysOf(cloud, layout, {message.header.stamp.toSec(), 0.05});
    const PosedBody car = carAhead();
    const CloudEdit edit{{car}, {{car.end, car.body.size}}, nullptr, 0.02, 0};
    editCloud(cloud, layout, sweep, edit, {});
    require(cloud.pointCount() <= sweep.rays.size(), "more points than rays");
    const CloudLayout again(cloud);
  });
}

}  // namespace forge
