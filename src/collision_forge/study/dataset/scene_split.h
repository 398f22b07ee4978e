#pragma once

#include <map>
#include <string>
#include <vector>

#include "collision_forge/study/dataset/options.h"

namespace forge {

/// "train", "val" and "test".
const std::vector<std::string>& splitNames();

/// The split of every scene. Scenes are dealt whole, in an order that follows from their names
/// alone: the first to val, the next to test, the rest to train, as many as the shares say, rounded
/// down, but at least one to each as long as there are three.
std::map<std::string, std::string> splitByScene(const std::vector<std::string>& scenes,
                                                const SplitOptions& options);

}  // namespace forge
