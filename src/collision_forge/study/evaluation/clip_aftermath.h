#pragma once

#include "collision_forge/base/scene/scene.h"
#include "collision_forge/io/collide/collide_clip.h"

namespace forge {

/// The clip's recorded future for a picture: the set's own attacker stands still from the crash on,
/// the clip's last frame, after which nobody knows where it drives.
Future withAttackerStopped(const CollideClip& clip, Future recorded);

}  // namespace forge
