#include "collision_forge/attack/search/request_constraints.h"

#include <algorithm>

#include "collision_forge/attack/search/judge.h"
#include "collision_forge/attack/verify/verification.h"

namespace forge {

std::array<double, 3> valuesTriedIn(const Range& range) {
  constexpr std::array<double, 3> kShares = {0.5, 0.2, 0.8};
  std::array<double, 3> values{};
  std::transform(kShares.begin(), kShares.end(), values.begin(),
                 [&](double share) { return range.min + share * (range.max - range.min); });
  return values;
}

RequestConstraints::RequestConstraints(const SearchInput& input, const AttackOptions& options)
    : input_(input), options_(options.verification), is_named_(hasConstraints(input.request)) {
  if (is_named_) judged_.agents = input.future.agents;
}

bool RequestConstraints::holds(const Track& attacker, const std::vector<TrajectoryPoint>& points,
                               std::size_t ego) {
  if (!is_named_) return true;
  judged_.ego = *input_.egos[ego];
  const Snapshot* start = &input_.snapshot;
  CollisionRequest request = input_.request;
  if (input_.underway != nullptr) {
    start = &input_.underway->start;
    request.tta += input_.snapshot.now - start->now;
    auto& states = judged_.ego.states;
    states.insert(states.begin(), input_.underway->ego.begin(), input_.underway->ego.end());
  }
  const CollisionReport report = verify({attacker.id, attacker.agent_class, attacker.size, points},
                                        {*start, judged_, request, input_.lanes}, options_);
  return meetsRequest(report, input_.request);
}

}  // namespace forge
