#include "collision_forge/ros/bags/sensor_writer.h"

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/NavSatFix.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <system_error>

#include "collision_forge/io/lidar/pcd_file.h"
#include "collision_forge/io/lidar/simulated_sweep.h"
#include "collision_forge/io/logs/nuscenes_json.h"
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

ros::Time toTime(std::int64_t timestamp_us) {
  return ros::Time().fromNSec(static_cast<std::uint64_t>(timestamp_us) * 1000U);
}

ros::Time stampOfFile(const NuScenesSensorFile& file) { return toTime(file.timestamp_us); }

geometry_msgs::Vector3 toVector(const Eigen::Vector3d& value) {
  geometry_msgs::Vector3 message;
  message.x = value.x();
  message.y = value.y();
  message.z = value.z();
  return message;
}

/// Reads all bytes of a file. Returns false, and counts the file as missing if it does not exist,
/// or as unreadable if it is no regular file or cannot be read to its end.
bool readBytes(const std::string& path, std::vector<std::uint8_t>& bytes, SensorCounts& counts) {
  std::error_code error;
  const auto type = std::filesystem::status(path, error).type();
  if (type == std::filesystem::file_type::not_found) {
    ++counts.missing;
    return false;
  }
  std::ifstream file;
  if (type == std::filesystem::file_type::regular) file.open(path, std::ios::binary);
  const auto size = file.is_open() ? std::filesystem::file_size(path, error) : 0;
  if (file.is_open() && !error) {
    bytes.resize(size);
    file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
    if (file) return true;
  }
  ++counts.unreadable;
  return false;
}

/// Returns the cloud of a lidar sweep (.pcd.bin). Throws CloudError.
PointCloud readSweep(std::vector<std::uint8_t> bytes) {
  PointCloud cloud;
  cloud.fields = nuScenesFields();
  cloud.point_step = 20;
  if (bytes.size() % cloud.point_step != 0) {
    throw CloudError(std::to_string(bytes.size()) + " bytes are no whole points of 20");
  }
  cloud.row_step = static_cast<std::uint32_t>(bytes.size());
  cloud.width = cloud.row_step / cloud.point_step;
  cloud.data = std::move(bytes);
  return cloud;
}

sensor_msgs::Imu toMessage(const NuScenesInertia& row) {
  sensor_msgs::Imu message;
  message.header.stamp = toTime(row.timestamp_us);
  message.header.frame_id = names::kBaseFrame;
  message.orientation.x = row.orientation.x();
  message.orientation.y = row.orientation.y();
  message.orientation.z = row.orientation.z();
  message.orientation.w = row.orientation.w();
  message.angular_velocity = toVector(row.rotation_rate);
  message.linear_acceleration = toVector(row.acceleration);
  return message;
}

sensor_msgs::NavSatFix toMessage(const NuScenesPlace& row, const GeoPoint& point) {
  sensor_msgs::NavSatFix message;
  message.header.stamp = toTime(row.timestamp_us);
  message.header.frame_id = names::kBaseFrame;
  message.latitude = point.latitude;
  message.longitude = point.longitude;
  message.altitude = std::numeric_limits<double>::quiet_NaN();  // nuScenes has none
  return message;
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

SensorWriter::SensorWriter(const NuScenesSensorScene& sensors, const NuScenesRecording& recording,
                           NewBag& bag)
    : sensors_(sensors), recording_(recording), bag_(bag) {
  if (!sensors.dataroot.empty()) readCanBus();
}

void SensorWriter::readCanBus() {
  const auto readInto = [&](auto& rows, const auto& read) {
    try {
      auto found = read(sensors_.dataroot, recording_.name);
      if (!found) {
        ++counts_.missing_can;
        return;
      }
      rows = std::move(*found);
      ++counts_.written;
    } catch (const NuScenesError&) {
      ++counts_.unreadable;
    }
  };
  readInto(inertia_, readInertia);
  if (geoPointOn(recording_.location, {0.0, 0.0})) readInto(places_, readPlaces);
}

void SensorWriter::writeMounting(const ros::Time& start) {
  tf2_msgs::TFMessage message;
  for (const NuScenesSensor& sensor : sensors_.sensors) {
    geometry_msgs::TransformStamped& transform = message.transforms.emplace_back();
    transform.header.stamp = start;
    transform.header.frame_id = names::kBaseFrame;
    transform.child_frame_id = frameOf(sensor);
    transform.transform.translation = toVector(sensor.translation);
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
    } else if (modality == "camera") {
      writePicture(file);
    } else {
      writeCloud(file);
    }
  }
  writeCanBusUpTo(timestamp_us);
}

bool SensorWriter::isWithinPoses(std::int64_t timestamp_us) const {
  return timestamp_us >= recording_.ego_poses.front().timestamp_us &&
         timestamp_us <= recording_.ego_poses.back().timestamp_us;
}

void SensorWriter::writeCanBusUpTo(std::int64_t timestamp_us) {
  const auto writeRows = [&](const auto& rows, std::size_t& next, const char* topic,
                             const auto& message_of) {
    for (; next < rows.size() && rows[next].timestamp_us <= timestamp_us; ++next) {
      if (!isWithinPoses(rows[next].timestamp_us)) continue;
      bag_.write(topic, toTime(rows[next].timestamp_us), message_of(rows[next]));
    }
  };
  writeRows(inertia_, next_inertia_, "/imu",
            [](const NuScenesInertia& row) { return toMessage(row); });
  writeRows(places_, next_place_, "/gps", [this](const NuScenesPlace& row) {
    return toMessage(row, *geoPointOn(recording_.location, row.position.head<2>()));
  });
}

void SensorWriter::writeCloud(const NuScenesSensorFile& file) {
  std::vector<std::uint8_t> bytes;
  if (!readBytes(file.path, bytes, counts_)) return;
  const NuScenesSensor& sensor = sensors_.sensors[file.sensor];
  sensor_msgs::PointCloud2 message;
  message.header.stamp = stampOfFile(file);
  message.header.frame_id = frameOf(sensor);
  try {
    putCloud(sensor.modality == "radar" ? readPcd(bytes) : readSweep(std::move(bytes)), message);
  } catch (const CloudError&) {
    ++counts_.unreadable;
    return;
  }
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
  if (!readBytes(file.path, image.data, counts_)) return;
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
