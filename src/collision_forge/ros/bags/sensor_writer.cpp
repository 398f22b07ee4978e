#include "collision_forge/ros/bags/sensor_writer.h"

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <vector>

#include "collision_forge/io/lidar/simulated_sweep.h"
#include "collision_forge/ros/messages/cloud_message.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {
namespace {

std::string frameOf(const NuScenesSensor& sensor) {
  std::string name = sensor.channel;
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char letter) { return std::tolower(letter); });
  return name;
}

ros::Time stampOfFile(const NuScenesSensorFile& file) {
  return ros::Time().fromNSec(static_cast<std::uint64_t>(file.timestamp_us) * 1000U);
}

/// Returns the bytes of a file; false if it does not exist.
bool readBytes(const std::string& path, std::vector<std::uint8_t>& bytes) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) return false;
  bytes.resize(static_cast<std::size_t>(file.tellg()));
  file.seekg(0);
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return true;
}

sensor_msgs::CameraInfo cameraInfoOf(const NuScenesSensor& camera, const NuScenesSensorFile& file) {
  sensor_msgs::CameraInfo info;
  info.width = file.width;
  info.height = file.height;
  info.distortion_model = "plumb_bob";
  info.D.assign(5, 0.0);  // the pictures are rectified
  std::copy(camera.intrinsic.begin(), camera.intrinsic.end(), info.K.begin());
  for (std::size_t i = 0; i < 3; ++i) {
    info.R[4 * i] = 1.0;
    std::copy_n(camera.intrinsic.begin() + static_cast<std::ptrdiff_t>(3 * i), 3,
                info.P.begin() + static_cast<std::ptrdiff_t>(4 * i));
  }
  return info;
}

}  // namespace

void SensorWriter::writeMounting(const ros::Time& start) {
  tf2_msgs::TFMessage message;
  for (const NuScenesSensor& sensor : sensors_.sensors) {
    geometry_msgs::TransformStamped& transform = message.transforms.emplace_back();
    transform.header.stamp = start;
    transform.header.frame_id = names::kBaseFrame;
    transform.child_frame_id = frameOf(sensor);
    transform.transform.translation.x = sensor.translation.x();
    transform.transform.translation.y = sensor.translation.y();
    transform.transform.translation.z = sensor.translation.z();
    const Eigen::Quaterniond rotation = sensor.rotation.normalized();
    transform.transform.rotation.x = rotation.x();
    transform.transform.rotation.y = rotation.y();
    transform.transform.rotation.z = rotation.z();
    transform.transform.rotation.w = rotation.w();
  }
  bag_.writeLatched(names::kStaticTf, start, message);
}

void SensorWriter::writeUpTo(std::int64_t timestamp_us) {
  const auto& files = sensors_.files;
  for (; next_ < files.size() && files[next_].timestamp_us <= timestamp_us; ++next_) {
    const NuScenesSensorFile& file = files[next_];
    const std::string& modality = sensors_.sensors[file.sensor].modality;
    if (file.path.empty()) {
      writeSimulated(file);
    } else if (modality == "lidar") {
      writeSweep(file);
    } else if (modality == "camera") {
      writePicture(file);
    } else {
      ++counts_.skipped;
    }
  }
}

void SensorWriter::writeSweep(const NuScenesSensorFile& file) {
  PointCloud cloud;
  cloud.fields = nuScenesFields();
  cloud.point_step = 20;
  if (!readBytes(file.path, cloud.data)) {
    ++counts_.missing;
    return;
  }
  if (cloud.data.size() % cloud.point_step != 0) {
    ++counts_.unreadable;
    return;
  }
  cloud.row_step = static_cast<std::uint32_t>(cloud.data.size());
  cloud.width = cloud.row_step / cloud.point_step;
  sensor_msgs::PointCloud2 message;
  message.header.stamp = stampOfFile(file);
  message.header.frame_id = frameOf(sensors_.sensors[file.sensor]);
  putCloud(std::move(cloud), message);
  bag_.write(bagTopic(message.header.frame_id.c_str()), message.header.stamp, message);
  ++counts_.written;
}

void SensorWriter::writeSimulated(const NuScenesSensorFile& file) {
  const auto pose = std::lower_bound(
      recording_.ego_poses.begin(), recording_.ego_poses.end(), file.timestamp_us,
      [](const NuScenesEgoPose& ego, std::int64_t time) { return ego.timestamp_us < time; });
  const NuScenesSensor& sensor = sensors_.sensors[file.sensor];
  sensor_msgs::PointCloud2 message;
  message.header.stamp = stampOfFile(file);
  message.header.frame_id = frameOf(sensor);
  putCloud(simulateSweep(recording_, sensor,
                         static_cast<std::size_t>(pose - recording_.ego_poses.begin())),
           message);
  bag_.write(bagTopic(message.header.frame_id.c_str()), message.header.stamp, message);
  ++counts_.written;
}

void SensorWriter::writePicture(const NuScenesSensorFile& file) {
  const NuScenesSensor& camera = sensors_.sensors[file.sensor];
  sensor_msgs::CompressedImage image;
  if (!readBytes(file.path, image.data)) {
    ++counts_.missing;
    return;
  }
  image.header.stamp = stampOfFile(file);
  image.header.frame_id = frameOf(camera);
  image.format = "jpeg";
  sensor_msgs::CameraInfo info = cameraInfoOf(camera, file);
  info.header = image.header;
  const std::string topic = bagTopic(image.header.frame_id.c_str());
  bag_.write(topic + "/image_rect_compressed", image.header.stamp, image);
  bag_.write(topic + "/camera_info", image.header.stamp, info);
  ++counts_.written;
}

}  // namespace forge
