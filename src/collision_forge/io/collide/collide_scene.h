#pragma once

#include <memory>

#include "collision_forge/base/scene/scene.h"
#include "collision_forge/io/collide/collide_clip.h"
#include "collision_forge/io/logs/options.h"

namespace forge {

/// A clip as the core's recording; snapshotAt() and recordedFuture() at clip.now() give what is
/// known then and what came after. Every box has `options.box`, and its middle is the recorded
/// position. Ego and others are as recorded in all frames; whoever is there in the last one goes
/// straight on for `options.tail` seconds at the velocity of the last interval (at the recorded
/// speed along the heading without a frame before), in steps of half a second.
///
/// The attacker's history in these files gives its future away: up to now only its state at now is
/// used, as two states, now and in the frame before, that go straight at the recorded speed. From
/// now on it is as recorded.
Scene toScene(const CollideClip& clip, const CollideOptions& options,
              std::shared_ptr<const LaneMap> map);

}  // namespace forge
