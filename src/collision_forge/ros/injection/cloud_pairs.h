#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "collision_forge/io/drawing/draw_clouds.h"

namespace forge {

/// A period of header stamps, s.
struct CloudPeriod {
  double begin = 0.0;
  double end = 0.0;
  std::size_t most = 0;  ///< pairs; evenly chosen from the clouds of the period
};

/// Reads the clouds of a period from a recorded bag and from the attacked bag that was made of it,
/// in base_link. Takes the first of `topics` (kAllClouds: of all topics of clouds, by name) that
/// has a changed cloud. Empty if no cloud of the period was changed. Clouds without transform and
/// unreadable ones are left out. Throws BagError.
std::vector<CloudPair> readCloudPairs(const std::string& recorded, const std::string& attacked,
                                      const std::vector<std::string>& topics,
                                      const CloudPeriod& period);

}  // namespace forge
