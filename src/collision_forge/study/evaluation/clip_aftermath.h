#pragma once

#include "collision_forge/base/scene/scene.h"
#include "collision_forge/io/collide/collide_clip.h"

namespace forge {

/// Returns `recorded` with the data set's attacker stopped at its pose in the last frame of the
/// clip, the time of the crash. Used for pictures: COLLIDE does not define its motion afterwards.
Future withAttackerStopped(const CollideClip& clip, Future recorded);

}  // namespace forge
