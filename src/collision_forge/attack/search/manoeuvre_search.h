#pragma once

#include <vector>

#include "collision_forge/attack/search/search_task.h"

namespace forge {

/// Largest number of vehicles that are searched in full. If there are more, one draft of each
/// vehicle is scored first, and only the vehicles with the best drafts are searched further.
inline constexpr int kDrafted = 6;

/// Searches for attacks in which the attacker drives as drivers do: along a route of lanes at one
/// chosen speed until its manoeuvre (leaving the lane, braking, crossing) leads to the contact.
/// Drafts one candidate per route and placement that fits the requested type (RouteDraft), scores
/// the candidates over all futures of the ego (FutureScorer), and perturbs the best ones.
///
/// Returns the attacks that hit the ego in at least one future (FutureScore::share > 0), highest
/// objective first; empty if there is none. If `input.underway` is set, returns all kept
/// candidates, even with share 0, highest objective first; the last element is the current plan;
/// empty if the attacker is not in the snapshot. Pointers in the result point into `input`. Random
/// draws depend only on the request's seed. Not for requests without plausibility: see
/// searchAttacks().
std::vector<FoundAttack> searchManoeuvres(const SearchInput& input, const AttackOptions& options);

}  // namespace forge
