#pragma once

#include <functional>
#include <string>
#include <vector>

#include "collision_forge/io/logs/options.h"

namespace forge {

/// Writes a bag as an MCAP file of profile ros1, aside and renamed. Every message has its bytes,
/// its topic and the bag's time; every connection is a channel with what its header says. Beside
/// them there are CrashTopics. Holds a chunk of either file and the bag's index. `on_progress` gets
/// the share done, 0..1. Returns what is copied, but beyond the limits of input, and so not
/// shown in CrashTopics. Throws BagError naming `in` for a bag that is truncated, damaged, no bag
/// or empty, and for one with a message at time 0, which means none; std::runtime_error naming
/// `out` where that cannot be written.
std::vector<std::string> exportToMcap(
    const std::string& in, const std::string& out, const DataOptions& options,
    const std::function<void(double)>& on_progress = [](double) {});

}  // namespace forge
