#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "collision_forge/base/scene/attack.h"

namespace forge {

/// Returns the first track with that id; nullptr if there is none. The pointer is valid until
/// `tracks` changes.
inline const Track* findTrack(const std::vector<Track>& tracks, const std::string& id) {
  const auto found = std::find_if(tracks.begin(), tracks.end(),
                                  [&](const Track& track) { return track.id == id; });
  return found == tracks.end() ? nullptr : &*found;
}

/// Returns the attacker's track up to t0: the `past` of an added vehicle, else its track among
/// `agents`, the tracks of a snapshot. Without either the track has the id, class and size of
/// `attacker` and no states.
inline Track attackerPast(const AttackerTrajectory& attacker, const std::vector<Track>& agents) {
  if (!attacker.isAdded()) {
    if (const Track* recorded = findTrack(agents, attacker.attacker_id)) return *recorded;
  }
  return {attacker.attacker_id, attacker.agent_class, attacker.size, attacker.past};
}

}  // namespace forge
