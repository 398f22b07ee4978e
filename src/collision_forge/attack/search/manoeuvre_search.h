#pragma once

#include <vector>

#include "collision_forge/attack/search/search_task.h"

namespace forge {

inline constexpr int kDrafted = 6;  ///< vehicles that are searched further: best first drafts

/// Searches for attacks by vehicles that drive as drivers do: along a route of lanes, at a speed
/// that they choose once, until they leave their lane, brake or fail to brake, or cross, for the
/// contact. Begins where the routes themselves lead to the ego, at the headings of the type, and
/// moves from the best ones. Best first; only attacks with a share above 0. Of an attacker that is
/// underway all that were kept, whatever their share, and last what it means to do. The draws
/// follow from the request's seed.
std::vector<FoundAttack> searchManoeuvres(const SearchInput& input, const AttackOptions& options);

}  // namespace forge
