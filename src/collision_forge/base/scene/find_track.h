#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "collision_forge/base/scene/track.h"

namespace forge {

/// The one of that id; null where there is none.
inline const Track* findTrack(const std::vector<Track>& tracks, const std::string& id) {
  const auto found = std::find_if(tracks.begin(), tracks.end(),
                                  [&](const Track& track) { return track.id == id; });
  return found == tracks.end() ? nullptr : &*found;
}

}  // namespace forge
