#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "collision_forge/io/logs/nuscenes_can_bus.h"
#include "collision_forge/io/logs/nuscenes_recording.h"
#include "collision_forge/io/logs/nuscenes_sensors.h"
#include "collision_forge/ros/bags/bag_file.h"

namespace forge {

/// The number of a scene's sensor files, by outcome.
struct SensorCounts {
  std::size_t written = 0;
  std::size_t missing = 0;      ///< files that do not exist
  std::size_t unreadable = 0;   ///< files that do not follow their format
  std::size_t missing_can = 0;  ///< files of the CAN bus that do not exist
};

/// Writes the sensor data of a scene into its bag. Frames are named after the channels, in lower
/// case: lidar sweeps and radar files as sensor_msgs/PointCloud2 on /lidar_top and /radar_front,
/// pictures as sensor_msgs/CompressedImage on /cam_front/image_rect_compressed with
/// sensor_msgs/CameraInfo on /cam_front/camera_info. The CAN bus gives sensor_msgs/Imu on /imu, and
/// the ego's position as sensor_msgs/NavSatFix on /gps where geoPointOn() knows the map, both in
/// the frame base_link and within the time of the ego poses. Topics and frames are named as by
/// other converters of nuScenes.
class SensorWriter {
 public:
  /// Reads the files of the CAN bus. `sensors` and `recording` must outlive the writer.
  SensorWriter(const NuScenesSensorScene& sensors, const NuScenesRecording& recording, NewBag& bag);

  /// Writes /tf_static from base_link to every sensor, latched.
  void writeMounting(const ros::Time& start);
  /// Writes the messages up to a time, us, that were not written yet.
  void writeUpTo(std::int64_t timestamp_us);

  const SensorCounts& counts() const { return counts_; }

 private:
  void readCanBus();
  bool isWithinPoses(std::int64_t timestamp_us) const;
  void writeCanBusUpTo(std::int64_t timestamp_us);
  /// Writes a sweep, or the returns of a radar.
  void writeCloud(const NuScenesSensorFile& file);
  void writePicture(const NuScenesSensorFile& file);
  void writeSimulated(const NuScenesSensorFile& file);

  const NuScenesSensorScene& sensors_;
  const NuScenesRecording& recording_;
  NewBag& bag_;
  std::size_t next_ = 0;
  std::vector<NuScenesInertia> inertia_;
  std::size_t next_inertia_ = 0;
  std::vector<NuScenesPlace> places_;
  std::size_t next_place_ = 0;
  SensorCounts counts_;
};

}  // namespace forge
