#pragma once

namespace forge {

class Section;

/// How vehicles are put into recorded lidar clouds (config/lidar.yaml).
struct LidarOptions {
  double range_noise = 0.0;  ///< m, standard deviation of the range of an added return; 0 to 1
  double sweep_time = 0.0;   ///< s, duration of a sweep whose points have no times; 0 to 1. The
                             ///< sweep ends at the cloud's stamp
  bool is_motion_corrected = true;  ///< true: points refer to the sensor's pose at the cloud's
                                    ///< stamp; false: to its pose at the point's own time
};

/// Reads the struct from its section. Throws ConfigError for a missing key or a value out of range.
void readOptions(Section& section, LidarOptions& options);

}  // namespace forge
