#pragma once

#include "collision_forge/attack/search/method_registry.h"
#include "collision_forge/io/collide/collide_clip.h"
#include "collision_forge/study/evaluation/options.h"

namespace forge {

/// The methods that a clip of COLLIDE can be asked for: "recorded" (recordedAttacker()),
/// "constant_velocity" (that of the clip), those of `methods`, "published_search" and
/// "network+published_search" (publishedSearchAttacker()), and where there is "published_network",
/// "published_network_lookahead": the same with the speed and acceleration at the end of the set's
/// own attacker, which the paper's released code looks at. The methods made of it read `clip`,
/// which must outlive them; a null clip serves for the names alone.
MethodRegistry clipMethods(const MethodRegistry& methods, const CollideClip* clip,
                           const EvaluationOptions& evaluation);

}  // namespace forge
