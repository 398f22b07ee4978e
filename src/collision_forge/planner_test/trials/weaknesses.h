#pragma once

#include <functional>
#include <string>
#include <vector>

#include "collision_forge/base/scene/manoeuvre.h"
#include "collision_forge/planner_test/trials/options.h"
#include "collision_forge/planner_test/trials/planner_result.h"

namespace forge {

/// A class of avoidable hits of a row of the test: same manoeuvre, kind of road and fault.
struct Weakness {
  RowKey row;
  Manoeuvre manoeuvre = Manoeuvre::kFollowerCloses;
  bool at_fault = false;
  ContactPlace place = ContactPlace::kElsewhere;
  std::vector<std::size_t> results;  ///< indices, the most severe hit first
};

/// Groups the hits in `results` into weaknesses, the most severe hit first (isMoreSevere()). Counts
/// fair hits (PlannerRow::is_fair) of at least `min_impact_speed` by attackers that had not
/// aborted, kept every limit and touched no other agent. Unless the planner is at fault, leaves out
/// hits from behind: those into the ego's rear and all with Manoeuvre::kFollowerCloses.
/// `manoeuvreOf` returns the requested manoeuvre of the case with a result's index.
std::vector<Weakness> findWeaknesses(const std::vector<PlannerTestResult>& results,
                                     const std::function<Manoeuvre(std::size_t)>& manoeuvreOf,
                                     const UntilHitOptions& options);

}  // namespace forge
