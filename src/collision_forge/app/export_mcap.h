#pragma once

#include <string>
#include <vector>

namespace forge {

struct Config;

/// File that `forge export` makes of a bag. NAME: the bag's file name without extension.
enum class BagExport {
  kMcap,      ///< OUT/NAME.mcap of profile ros1
  kRos2Mcap,  ///< OUT/NAME.mcap of profile ros2
  kRosbag2,   ///< the folder OUT/NAME with NAME.mcap of profile ros2 and metadata.yaml
};

/// Exports each bag (path) into the folder `out`, which is created and locked. If at least one bag
/// is exported, now or before, also writes OUT/layout.json (foxgloveLayout()) unless it exists, and
/// for ROS 2 the interface package of collision_forge's message types (writeRos2Package()). Skips a
/// bag whose output exists (kRosbag2: its metadata.yaml), since a file gets its name only when it
/// is complete; if that file has the other profile, the bag counts as failed. Reports bags that
/// cannot be converted on stderr, removes their output and continues with the next one; prints the
/// number of newly exported bags, and the number of skipped ones, on stdout. Returns kExitError if
/// any bag failed, else kExitOk. Throws std::invalid_argument for two bags of the same name, and
/// std::runtime_error if another process holds the folder's lock.
int exportBags(const std::vector<std::string>& bags, const std::string& out, BagExport format,
               const Config& config);

}  // namespace forge
