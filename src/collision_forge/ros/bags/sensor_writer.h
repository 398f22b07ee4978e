#pragma once

#include <cstddef>
#include <string>

#include "collision_forge/io/logs/nuscenes_recording.h"
#include "collision_forge/io/logs/nuscenes_sensors.h"
#include "collision_forge/ros/bags/bag_file.h"

namespace forge {

/// The number of a scene's sensor files, by outcome.
struct SensorCounts {
  std::size_t written = 0;     ///< sweeps and pictures in the bag, also simulated ones
  std::size_t missing = 0;     ///< files that do not exist
  std::size_t unreadable = 0;  ///< sweeps whose size is no multiple of a point's 20 bytes
  std::size_t skipped = 0;     ///< of kinds that are not converted: radar
};

/// Writes the sensor data of a scene into its bag. Frames are named after the channels, in lower
/// case: lidar sweeps as sensor_msgs/PointCloud2 on /lidar_top, pictures as
/// sensor_msgs/CompressedImage on /cam_front/image_rect_compressed with
/// sensor_msgs/CameraInfo on /cam_front/camera_info, as other converters of nuScenes name them.
/// Stamp and record time are the file's timestamp. Files that are missing or unreadable are counted
/// and left out. A file with an empty path is a sweep that is simulated (simulateSweep()) at the
/// first ego pose at or after its timestamp.
class SensorWriter {
 public:
  /// All three must outlive the writer. `recording`: of the same scene, for simulated sweeps.
  SensorWriter(const NuScenesSensorScene& sensors, const NuScenesRecording& recording, NewBag& bag)
      : sensors_(sensors), recording_(recording), bag_(bag) {}

  /// Writes /tf_static from base_link to every sensor, also a radar, latched; `start`: stamp and
  /// record time. Throws BagError.
  void writeMounting(const ros::Time& start);
  /// Writes the files with timestamps up to `timestamp_us` (us, inclusive) that were not written
  /// yet, in the order of NuScenesSensorScene::files. Throws BagError if the bag cannot be written.
  void writeUpTo(std::int64_t timestamp_us);

  /// Returns the counts of the files up to the last writeUpTo().
  const SensorCounts& counts() const { return counts_; }

 private:
  void writeSweep(const NuScenesSensorFile& file);
  void writePicture(const NuScenesSensorFile& file);
  void writeSimulated(const NuScenesSensorFile& file);

  const NuScenesSensorScene& sensors_;
  const NuScenesRecording& recording_;
  NewBag& bag_;
  std::size_t next_ = 0;  ///< index of the next file in NuScenesSensorScene::files
  SensorCounts counts_;
};

}  // namespace forge
