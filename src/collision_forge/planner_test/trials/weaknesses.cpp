#include "collision_forge/planner_test/trials/weaknesses.h"

#include <algorithm>
#include <utility>

namespace forge {
namespace {

/// A row of a result.
struct Hit {
  std::size_t result = 0;
  const PlannerRow* row = nullptr;

  const PlannerContact& contact() const { return *row->outcome.contact; }
};

/// Returns whether the attacker came from behind and is at fault: it hit the ego's rear, or it is a
/// follower that hit a turning ego.
bool isRearEndFault(const PlannerContact& contact, Manoeuvre manoeuvre) {
  if (contact.at_fault) return false;
  return manoeuvre == Manoeuvre::kFollowerCloses || contact.cause == ContactCause::kRear ||
         (contact.cause == ContactCause::kStoppedEgo && contact.ego_side == Side::kRear);
}

bool showsWeakness(const PlannerRow& row, const UntilHitOptions& options) {
  const RolloutOutcome& outcome = row.outcome;
  return outcome.failure == PlannerFailure::kNone && outcome.contact &&
         outcome.contact->is_attacker && row.is_fair &&
         row.attacker.phase != AttackerPhase::kDrivingOn && row.attacker.broken_limit.empty() &&
         row.attacker.touched.empty() && outcome.contact->impact_speed >= options.min_impact_speed;
}

std::vector<Hit> severestFirst(const std::vector<PlannerTestResult>& results,
                               const UntilHitOptions& options) {
  std::vector<Hit> hits;
  for (std::size_t i = 0; i < results.size(); ++i) {
    for (const PlannerRow& row : results[i].rows) {
      if (showsWeakness(row, options)) hits.push_back({i, &row});
    }
  }
  std::stable_sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) {
    return isMoreSevere(a.contact(), b.contact());
  });
  return hits;
}

}  // namespace

std::vector<Weakness> findWeaknesses(const std::vector<PlannerTestResult>& results,
                                     const std::function<Manoeuvre(std::size_t)>& manoeuvreOf,
                                     const UntilHitOptions& options) {
  std::vector<Weakness> weaknesses;
  for (const Hit& hit : severestFirst(results, options)) {
    const PlannerContact& contact = hit.contact();
    const Manoeuvre manoeuvre = manoeuvreOf(hit.result);
    if (isRearEndFault(contact, manoeuvre)) continue;
    const auto isOf = [&](const Weakness& known) {
      return rowName(known.row) == rowName(*hit.row) && known.manoeuvre == manoeuvre &&
             known.at_fault == contact.at_fault && known.place == contact.place;
    };
    const auto known = std::find_if(weaknesses.begin(), weaknesses.end(), isOf);
    if (known != weaknesses.end()) {
      known->results.push_back(hit.result);
    } else {
      weaknesses.push_back(
          {keyOf(*hit.row), manoeuvre, contact.at_fault, contact.place, {hit.result}});
    }
  }
  return weaknesses;
}

}  // namespace forge
