#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace forge {

/// Some of the clips at these paths whose nominal time from now to the crash is `min_tta` s or
/// more: of the types in turn, in the order of kCollisionTypes, one each, at random; a type that
/// has none left is passed over. The same paths and seed give the same clips, and of a greater
/// count the first ones. Throws std::invalid_argument where there are fewer than `count`,
/// CollideError for a path that is no clip's.
std::vector<std::string> drawClips(const std::vector<std::string>& paths, std::size_t count,
                                   double min_tta, std::uint64_t seed);

/// The path of the clip of that name, with or without its ending, else of the only clip that has
/// `name` in its own. Throws std::invalid_argument for a name that no clip has, or several have in
/// theirs; the message says which.
std::string clipNamed(const std::vector<std::string>& paths, const std::string& name);

}  // namespace forge
