#include "collision_forge/study/evaluation/clip_aftermath.h"

#include <optional>

namespace forge {

Future withAttackerStopped(const CollideClip& clip, Future recorded) {
  const double crash = clip.times.back();
  for (Track& track : recorded.agents) {
    if (track.id != clip.attacker_id) continue;
    const std::optional<AgentState> last = stateAt(track, crash);
    if (!last) continue;
    for (AgentState& state : track.states) {
      if (state.time <= crash) continue;
      state.pose = last->pose;
      state.velocity = {0.0, 0.0};
    }
  }
  return recorded;
}

}  // namespace forge
