#pragma once

#include <functional>
#include <string>
#include <vector>

#include "collision_forge/io/logs/options.h"
#include "collision_forge/ros/bags/mcap_messages.h"

namespace forge {

/// Contents of a written MCAP file.
struct McapExport {
  std::vector<McapMessages::Topic> topics;
  ros::Time begin;                    ///< of the bag
  ros::Time end;                      ///< of the bag
  std::vector<std::string> warnings;  ///< of CrashTopics and McapMessages
};

/// Converts a bag to an MCAP file, written to a temporary file and renamed. Keeps topic and bag
/// time of each message; in profile ros1 also its bytes and the header of its connection, as
/// metadata of the channel. Adds CrashTopics. Memory: one chunk of each file and the bag's index.
/// `on_progress` receives the completed share 0..1. Throws BagError with `in` for a truncated,
/// damaged or empty bag, a file that is no bag, and a message at time 0 ("no time");
/// std::runtime_error with `out` if that cannot be written.
McapExport exportToMcap(
    const std::string& in, const std::string& out, const DataOptions& options,
    McapProfile profile = McapProfile::kRos1,
    const std::function<void(double)>& on_progress = [](double) {});

}  // namespace forge
