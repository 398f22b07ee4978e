#include "collision_forge/io/lidar/options.h"

#include "collision_forge/base/config/section.h"

namespace forge {

void readOptions(Section& section, LidarOptions& options) {
  options.range_noise = section.within("range_noise", 0.0, 1.0);
  options.sweep_time = section.within("sweep_time", 0.0, 1.0);
  options.is_motion_corrected =
      section.choice<bool>("is_motion_corrected", {{"true", true}, {"false", false}});
}

}  // namespace forge
