#pragma once

namespace forge {

class Section;

/// How vehicles are put into recorded lidar clouds (config/lidar.yaml).
struct LidarOptions {
  double range_noise = 0.0;         ///< m, standard deviation of the range of an added return
  double sweep_time = 0.0;          ///< s that a sweep without times of its points takes
  bool is_motion_corrected = true;  ///< points refer to the sensor's pose at the cloud's stamp
};

/// Throws ConfigError for a missing key or a value out of range.
void readOptions(Section& section, LidarOptions& options);

}  // namespace forge
