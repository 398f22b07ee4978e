#pragma once

#include <string>

namespace forge {

/// Letters of an id by which people name an agent; those of nuScenes have 32.
inline constexpr std::size_t kShortId = 6;

/// An id as it is shown. One that is hardly longer, as `added-1`, is whole.
inline std::string shortId(const std::string& id) {
  return id.size() <= kShortId + 2 ? id : id.substr(0, kShortId);
}

}  // namespace forge
