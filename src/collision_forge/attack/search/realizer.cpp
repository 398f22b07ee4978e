#include "collision_forge/attack/search/realizer.h"

#include <algorithm>
#include <cmath>
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

}  // namespace

Realization realize(const RealizationTask& task, const AttackOptions& options) {
  checkPatterns(task.patterns, task.input.snapshot);
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

}  // namespace forge
