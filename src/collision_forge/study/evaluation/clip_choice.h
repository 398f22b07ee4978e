#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace forge {

/// Draws `count` of the clips with a nominal TTA of at least `min_tta` s. Draws one clip at random
/// from each type in turn, in the order of kCollisionTypes, and skips types without clips left. For
/// the same paths and seed, a smaller count gives a prefix of the result. Throws
/// std::invalid_argument if fewer than `count` clips qualify, CollideError for an invalid file
/// name.
std::vector<std::string> drawClips(const std::vector<std::string>& paths, std::size_t count,
                                   double min_tta, std::uint64_t seed);

/// Returns the path of the clip with the file name `name` (extension optional), else of the only
/// clip whose file name contains `name`. Throws std::invalid_argument if no clip matches or several
/// do.
std::string clipNamed(const std::vector<std::string>& paths, const std::string& name);

}  // namespace forge
