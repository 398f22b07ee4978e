#pragma once

#include <vector>

#include "collision_forge/attack/search/search_task.h"

namespace forge {

/// Searches arrivals (contact offset, relative heading, speed, start and end acceleration, time)
/// and families of motion for attacks whose conditions hold in most of the ego's futures: the
/// arrivals that the patterns tell, others around them and along the sides that they touch, the
/// best ones moved nearer to their pattern, perturbations of the best, then the bicycle where no
/// quintic is good enough. Believable attackers are searched by searchManoeuvres() instead, unless
/// any motion will do. Best first; only attacks with a share above 0. The draws follow from the
/// request's seed.
std::vector<FoundAttack> searchAttacks(const SearchInput& input, const AttackOptions& options);

}  // namespace forge
