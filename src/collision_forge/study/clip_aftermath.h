#pragma once

#include "collision_forge/data/collide_clip.h"
#include "collision_forge/scene/scene.h"

namespace forge {

/// The clip's recorded future for a picture: the set's own attacker stands still from the crash on,
/// the clip's last frame, after which nobody knows where it drives.
Future withAttackerStopped(const CollideClip& clip, Future recorded);

}  // namespace forge
