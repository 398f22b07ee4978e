#pragma once

#include <memory>

#include "collision_forge/base/scene/scene.h"
#include "collision_forge/io/collide/collide_clip.h"
#include "collision_forge/io/logs/options.h"

namespace forge {

/// Converts a clip to a Scene with the clip's name, on the clock of its times; snapshotAt() and
/// recordedFuture() at clip.now() return history and future. All vehicles are cars. `map` may be
/// null. Every box has size `options.box` and is centred at the recorded position. The ego and the
/// other agents are as recorded in all frames. A vehicle that is in the last frame continues for
/// `options.tail` seconds at the velocity of the last interval (without a previous frame, at the
/// recorded speed along the heading), in equal steps of at most 0.5 s, the last one at the end of
/// that time. All velocities are then derived from the positions (deriveVelocities()). Agents are
/// in the order of the clip's tracks; vehicles without a state are left out.
///
/// In these files the attacker's history reveals its future. Therefore only its state at t0 is used
/// up to t0: as two states, at t0 and one frame before, at the recorded speed along its heading.
/// From t0 on it is as recorded.
Scene toScene(const CollideClip& clip, const CollideOptions& options,
              std::shared_ptr<const LaneMap> map);

}  // namespace forge
