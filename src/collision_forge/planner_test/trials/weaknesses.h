#pragma once

#include <functional>
#include <string>
#include <vector>

#include "collision_forge/base/scene/manoeuvre.h"
#include "collision_forge/planner_test/trials/options.h"
#include "collision_forge/planner_test/trials/planner_result.h"

namespace forge {

/// A way in which a planner is hit though it could escape: by a manoeuvre, at a kind of place, by
/// its own fault or not.
struct Weakness {
  std::string planner;
  PolicyKind policy = PolicyKind::kAdaptive;
  Manoeuvre manoeuvre = Manoeuvre::kFollowerCloses;
  bool at_fault = false;
  ContactPlace place = ContactPlace::kElsewhere;
  std::vector<std::size_t> results;  ///< indices, the hardest impact first
};

/// The weaknesses that results show, that with the hardest impact first. Counted are fair hits
/// (PlannerRow::is_fair) by attackers that had not given up, kept every limit and touched nobody
/// else, no softer than `min_impact_speed`. Hits by attackers from behind are left out unless the
/// planner is at fault: those into the ego's rear, and all of followers that close. `manoeuvreOf`:
/// what was asked for in the case of a result.
std::vector<Weakness> findWeaknesses(const std::vector<PlannerTestResult>& results,
                                     const std::function<Manoeuvre(std::size_t)>& manoeuvreOf,
                                     const UntilHitOptions& options);

}  // namespace forge
