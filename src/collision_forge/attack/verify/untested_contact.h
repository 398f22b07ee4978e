#pragma once

#include "collision_forge/base/scene/attack.h"

namespace forge {

/// Returns true if the recording is too short to test an attack: `tested`, its report on the
/// recording, has no contact, and the ego's recording (its states must not be empty) ends before
/// the time of impact that `pattern` predicts.
inline bool endsBeforeContact(const Track& recorded_ego, const CollisionPattern& pattern,
                              const CollisionReport& tested) {
  return !tested.contact && recorded_ego.states.back().time < pattern.time;
}

}  // namespace forge
