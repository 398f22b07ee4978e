#pragma once

#include <functional>
#include <string>
#include <vector>

#include "collision_forge/base/scene/manoeuvre.h"
#include "collision_forge/planner_test/trials/options.h"
#include "collision_forge/planner_test/trials/planner_result.h"

namespace forge {

/// A class of avoidable hits of one row of the test: same manoeuvre, kind of road and fault.
struct Weakness {
  RowKey row;                                        ///< planner, attacker policy and background
  Manoeuvre manoeuvre = Manoeuvre::kFollowerCloses;  ///< requested manoeuvre of the attacker
  bool at_fault = false;  ///< the ego is at fault (PlannerContact::at_fault)
  ContactPlace place = ContactPlace::kElsewhere;  ///< kind of road at the contact
  /// Indices in the `results` of findWeaknesses(), the most severe hit first.
  std::vector<std::size_t> results;
};

/// Groups the hits in `results` into weaknesses, the weakness with the most severe hit first
/// (isMoreSevere()). Counts fair hits (PlannerRow::is_fair) of at least `options.min_impact_speed`
/// by attackers that had not aborted (AttackerPhase::kDrivingOn), kept every limit and touched no
/// other agent, in rollouts without a failure. Unless the planner is at fault, leaves out hits from
/// behind: hits with ContactCause::kRear, hits into the rear of a stopped ego, and all with
/// Manoeuvre::kFollowerCloses. `manoeuvreOf`: called for each counted hit with its index in
/// `results`; returns the requested manoeuvre of that case.
std::vector<Weakness> findWeaknesses(const std::vector<PlannerTestResult>& results,
                                     const std::function<Manoeuvre(std::size_t)>& manoeuvreOf,
                                     const UntilHitOptions& options);

}  // namespace forge
