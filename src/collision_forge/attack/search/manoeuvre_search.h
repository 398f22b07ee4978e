#pragma once

#include <vector>

#include "collision_forge/attack/search/search_task.h"

namespace forge {

inline constexpr int kDrafted = 6;  ///< vehicles that are searched further: best first drafts

/// Searches for attacks by vehicles that drive like drivers: along a route of lanes at one chosen
/// speed until their manoeuvre (leaving the lane, braking, crossing) leads to the contact. Starts
/// where routes lead to the ego at the type's headings, then perturbs the best. Returns attacks
/// with a share above 0, best first. If `input.underway` is set, returns all kept candidates, even
/// with share 0; the last element is the current plan. Random draws depend only on the request's
/// seed.
std::vector<FoundAttack> searchManoeuvres(const SearchInput& input, const AttackOptions& options);

}  // namespace forge
