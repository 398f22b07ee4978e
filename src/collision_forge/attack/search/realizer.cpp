#include "collision_forge/attack/search/realizer.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "collision_forge/attack/search/attack_search.h"
#include "collision_forge/attack/search/judge.h"
#include "collision_forge/base/scene/find_track.h"
#include "collision_forge/base/scene/input_limits.h"
#include "collision_forge/base/scene/number_words.h"

namespace forge {
namespace {

void checkPatterns(const std::vector<CollisionPattern>& patterns, const Snapshot& snapshot) {
  for (const CollisionPattern& pattern : patterns) {
    if (!findTrack(snapshot.agents, pattern.attacker_id)) {
      throw InputError("the pattern's attacker_id \"" + pattern.attacker_id +
                       "\" is not in the scene");
    }
    if (!(pattern.time > snapshot.now)) {
      throw InputError("the pattern's time is not after t0");
    }
    if (!pattern.ego.center.isFinite() || !pattern.attacker_offset.isFinite() ||
        !std::isfinite(pattern.attacker_speed)) {
      throw InputError("the pattern of attacker_id \"" + pattern.attacker_id +
                       "\" has an ego, an attacker_offset or an attacker_speed that is "
                       "not finite");
    }
    if (!(pattern.tolerance >= 0.0)) {
      throw InputError("the pattern's tolerance = " + numberText(pattern.tolerance) +
                       " m must be at least 0");
    }
  }
}

Realization realizeTogether(const RealizationTask& task, const AttackOptions& options) {
  const VerificationInput& input = task.input;
  AttackJudge judge(input, options, task.exact);
  const std::vector<FoundAttack> attacks =
      searchAttacks({input.snapshot, input.future, judge.searched(), task.patterns, input.request,
                     input.lanes, task.exact, task.ways, task.motion},
                    options);
  for (const FoundAttack& attack : attacks) {
    const Track& agent = *attack.attacker;
    Realization found;
    found.aim = *attack.aim;
    found.trajectory = {agent.id, agent.agent_class, agent.size, attack.points};
    found.effort = attack.effort;
    if (judge.accepts(found, agent, attack.hits)) return found;
  }
  return declined(judge.refusal(task.patterns));
}

/// Groups the patterns by attacker, in the order of the first patterns.
std::vector<std::vector<CollisionPattern>> byAttacker(
    const std::vector<CollisionPattern>& patterns) {
  std::vector<std::vector<CollisionPattern>> groups;
  for (const CollisionPattern& pattern : patterns) {
    auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& other) {
      return other.front().attacker_id == pattern.attacker_id;
    });
    if (group == groups.end()) group = groups.emplace(groups.end());
    group->push_back(pattern);
  }
  return groups;
}

Realization realizeInTurn(const RealizationTask& task, const AttackOptions& options) {
  std::optional<Realization> best;
  for (const std::vector<CollisionPattern>& patterns : byAttacker(task.patterns)) {
    Realization answer = realizeTogether(
        {patterns, task.input, task.exact, task.ways, task.motion, std::nullopt}, options);
    const bool is_found = answer.status.code == StatusCode::kOk;
    const bool has_attack = best && best->status.code == StatusCode::kOk;
    if (best && (!is_found || (has_attack && worthOf(answer) <= worthOf(*best)))) continue;
    best = std::move(answer);
    if (is_found && worthOf(*best) >= *task.enough) break;
  }
  return best ? *best : realizeTogether(task, options);
}

}  // namespace

Realization realize(const RealizationTask& task, const AttackOptions& options) {
  checkPatterns(task.patterns, task.input.snapshot);
  return task.enough ? realizeInTurn(task, options) : realizeTogether(task, options);
}

}  // namespace forge
