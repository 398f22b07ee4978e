#pragma once

#include <string>
#include <vector>

namespace forge {

struct Config;

/// File that `forge export` makes of a bag.
enum class BagExport {
  kMcap,      ///< OUT/NAME.mcap of profile ros1
  kRos2Mcap,  ///< OUT/NAME.mcap of profile ros2
  kRosbag2,   ///< the folder OUT/NAME with NAME.mcap of profile ros2 and metadata.yaml
};

/// Exports each bag, and writes OUT/layout.json for Foxglove and Lichtblick. With ROS 2 also
/// writes the interface package of the own message types into OUT. Skips bags that are exported: a
/// file gets its name only when it is complete. Reports bags that cannot be converted on stderr and
/// continues with the next one. Returns kExitError if any bag failed, else kExitOk. Throws
/// std::invalid_argument for two bags of the same name.
int exportBags(const std::vector<std::string>& bags, const std::string& out, BagExport format,
               const Config& config);

}  // namespace forge
