#pragma once

#include <vector>

#include "collision_forge/attack/search/search_task.h"

namespace forge {

/// Searches for attacks that meet the request in as many of the ego's futures as possible. Samples
/// arrivals (relative pose, heading, speed, accelerations, time) at the given patterns, around them
/// and along the touched sides; corrects the best ones towards their pattern; perturbs the best;
/// and tries the bicycle family if no quintic is good enough. If SearchInput::isByRoutes() is true,
/// returns searchManoeuvres() instead. Returns the attacks that hit the ego in at least one future
/// (FutureScore::share > 0), highest objective first, at most 2 * SearchOptions::kept; empty if
/// there is none. Their pointers point into `input`. Random draws depend only on the request's
/// seed.
std::vector<FoundAttack> searchAttacks(const SearchInput& input, const AttackOptions& options);

}  // namespace forge
