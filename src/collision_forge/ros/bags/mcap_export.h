#pragma once

#include <functional>
#include <string>
#include <vector>

#include "collision_forge/io/logs/options.h"
#include "collision_forge/ros/bags/mcap_messages.h"

namespace forge {

/// Contents of a written MCAP file.
struct McapExport {
  std::vector<McapMessages::Topic> topics;  ///< McapMessages::topics()
  ros::Time begin;                          ///< earliest record time in the bag
  ros::Time end;                            ///< latest record time in the bag
  std::vector<std::string> warnings;        ///< lines of CrashTopics, then of McapMessages
};

/// Converts the bag at path `in` to the MCAP file `out`, written to a temporary file and renamed.
/// Keeps topic and record time of each message; in profile ros1 also its bytes and the header of
/// its connection, as metadata of the channel. Adds CrashTopics, for the agents on injected_agents
/// if the bag has this topic (recorded live), else on agents. Memory: one chunk of each file and
/// the bag's index. `options`: ego vehicle and input limits for CrashTopics. `on_progress` receives
/// the completed share 0..1 before each message and 1 at the end, in the calling thread. Throws
/// BagError with `in` for a truncated, damaged or empty bag, a file that is no bag, and a message
/// at time 0 ("no time"); std::runtime_error with `out` if that cannot be written.
McapExport exportToMcap(
    const std::string& in, const std::string& out, const DataOptions& options,
    McapProfile profile = McapProfile::kRos1,
    const std::function<void(double)>& on_progress = [](double) {});

}  // namespace forge
