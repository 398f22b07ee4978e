#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "collision_forge/base/scene/attack.h"

namespace forge {

/// The one of that id; null where there is none.
inline const Track* findTrack(const std::vector<Track>& tracks, const std::string& id) {
  const auto found = std::find_if(tracks.begin(), tracks.end(),
                                  [&](const Track& track) { return track.id == id; });
  return found == tracks.end() ? nullptr : &*found;
}

/// What the attacker did up to now: its own past if it was added, else its track among `agents`; a
/// track without states where there is none.
inline Track attackerPast(const AttackerTrajectory& attacker, const std::vector<Track>& agents) {
  if (!attacker.isAdded()) {
    if (const Track* recorded = findTrack(agents, attacker.attacker_id)) return *recorded;
  }
  return {attacker.attacker_id, attacker.agent_class, attacker.size, attacker.past};
}

}  // namespace forge
