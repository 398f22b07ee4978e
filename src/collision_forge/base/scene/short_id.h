#pragma once

#include <string>

namespace forge {

/// Characters of a shortened id for people; nuScenes' ids have 32.
inline constexpr std::size_t kShortId = 6;

/// Returns the first kShortId characters of an id; an id at most two longer ("added-1") stays
/// whole.
inline std::string shortId(const std::string& id) {
  return id.size() <= kShortId + 2 ? id : id.substr(0, kShortId);
}

}  // namespace forge
