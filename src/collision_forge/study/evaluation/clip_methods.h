#pragma once

#include "collision_forge/attack/search/method_registry.h"
#include "collision_forge/io/collide/collide_clip.h"
#include "collision_forge/study/evaluation/options.h"

namespace forge {

/// Returns the methods available for COLLIDE clips:
/// - "recorded": recordedAttacker();
/// - "constant_velocity": constantVelocityAttacker(), replaces the entry of `methods`;
/// - all other entries of `methods`;
/// - "published_search", "network+published_search": publishedSearchAttacker();
/// - "published_network_lookahead", if `methods` has "published_network": the same network with the
///   final speed and acceleration of the data set's attacker, as in the paper's released code.
///
/// The methods read `clip`, which must outlive them; it may be null if only names are needed.
MethodRegistry clipMethods(const MethodRegistry& methods, const CollideClip* clip,
                           const EvaluationOptions& evaluation);

}  // namespace forge
