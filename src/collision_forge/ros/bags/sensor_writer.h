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
  /// Sweeps, radar files and pictures in the bag, also simulated ones, and the files of the CAN bus
  /// that were read.
  std::size_t written = 0;
  std::size_t missing = 0;  ///< sensor files that do not exist
  /// Files that are not regular, cannot be read to their end or do not follow their format, also
  /// of the CAN bus.
  std::size_t unreadable = 0;
  std::size_t missing_can = 0;  ///< files of the CAN bus that do not exist
};

/// Writes the sensor data of a scene into its bag. Frames are named after the channels, in lower
/// case: lidar sweeps and radar files as sensor_msgs/PointCloud2 on /lidar_top and /radar_front,
/// pictures as sensor_msgs/CompressedImage on /cam_front/image_rect_compressed with
/// sensor_msgs/CameraInfo on /cam_front/camera_info. The CAN bus gives sensor_msgs/Imu on /imu, and
/// the ego's position as sensor_msgs/NavSatFix on /gps where geoPointOn() knows the map, both in
/// the frame base_link and within the time of the ego poses. The axes of the inertial measurement
/// unit are taken as the axes of base_link, since nuScenes has no mounting of it
/// (calibrated_sensor.json). Topics and frames are named as by other converters of nuScenes. Stamp
/// and record time are the timestamp of the file, or of the message of the CAN bus. Files that are
/// missing or unreadable are counted and left out. A file with an empty path is a sweep that is
/// simulated (simulateSweep()) at the first ego pose at or after its timestamp.
class SensorWriter {
 public:
  /// Reads the files of the CAN bus, unless NuScenesSensorScene::dataroot is empty. All three must
  /// outlive the writer. `recording`: of the same scene, for simulated sweeps and for the CAN bus.
  SensorWriter(const NuScenesSensorScene& sensors, const NuScenesRecording& recording, NewBag& bag);

  /// Writes /tf_static from base_link to every sensor, latched; `start`: stamp and record time.
  /// Throws BagError.
  void writeMounting(const ros::Time& start);
  /// Writes the files with timestamps up to `timestamp_us` (us, inclusive) that were not written
  /// yet, in the order of NuScenesSensorScene::files, then the messages of the CAN bus up to that
  /// time. Throws BagError if the bag cannot be written.
  void writeUpTo(std::int64_t timestamp_us);

  /// Returns the counts of the files up to the last writeUpTo(), and of the CAN bus's files.
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
  std::size_t next_ = 0;  ///< index of the next file in NuScenesSensorScene::files
  std::vector<NuScenesInertia> inertia_;
  std::size_t next_inertia_ = 0;  ///< index of the next element of `inertia_`
  std::vector<NuScenesPlace> places_;
  std::size_t next_place_ = 0;  ///< index of the next element of `places_`
  SensorCounts counts_;
};

}  // namespace forge
