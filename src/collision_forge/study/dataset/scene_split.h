#pragma once

#include <map>
#include <string>
#include <vector>

#include "collision_forge/study/dataset/options.h"

namespace forge {

/// Returns {"train", "val", "test"}.
const std::vector<std::string>& splitNames();

/// Returns the split (an element of splitNames()) of each scene by the name of the scene; `scenes`
/// are names, which may repeat. Orders the scenes by a hash of their names and assigns the first to
/// val, the next to test and the rest to train. Counts are the shares rounded down, but with three
/// scenes or more at least one for each split with a share above 0.
std::map<std::string, std::string> splitByScene(const std::vector<std::string>& scenes,
                                                const SplitOptions& options);

}  // namespace forge
