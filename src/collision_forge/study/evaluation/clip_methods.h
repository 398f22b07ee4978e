#pragma once

#include "collision_forge/attack/search/method_registry.h"
#include "collision_forge/io/collide/collide_clip.h"
#include "collision_forge/study/evaluation/options.h"

namespace forge {

/// Returns the methods available for COLLIDE clips:
/// - "recorded": recordedAttacker();
/// - "constant_velocity": constantVelocityAttacker(), replaces the entry of `methods`;
/// - all other entries of `methods`, in their order.
///
/// The first two methods read `clip`, which must outlive them, and return an attack with an empty
/// report; `clip` may be null if only names are needed. They are not seeded. `evaluation` gives the
/// size of the attacker's box.
MethodRegistry clipMethods(const MethodRegistry& methods, const CollideClip* clip,
                           const EvaluationOptions& evaluation);

}  // namespace forge
