#pragma once

#include <functional>
#include <string>
#include <vector>

#include "collision_forge/io/logs/options.h"

namespace forge {

/// Converts a bag to an MCAP file of profile ros1, written to a temporary file and renamed. Keeps
/// bytes, topic and bag time of each message; each connection becomes a channel with the metadata
/// of its header. Adds CrashTopics. Memory: one chunk of each file and the bag's index.
/// `on_progress` receives the completed share 0..1. Returns CrashTopics::warnings(). Throws
/// BagError with `in` for a truncated, damaged or empty bag, a file that is no bag, and a message
/// at time 0 ("no time"); std::runtime_error with `out` if that cannot be written.
std::vector<std::string> exportToMcap(
    const std::string& in, const std::string& out, const DataOptions& options,
    const std::function<void(double)>& on_progress = [](double) {});

}  // namespace forge
