#include "collision_forge/base/scene/hitched.h"

#include <algorithm>
#include <cmath>

namespace forge {
namespace {

constexpr double kDrawbar = 3.0;         // m between the boxes of a vehicle and its trailer
constexpr double kSplit = 0.5;           // m between the boxes of two halves
constexpr std::size_t kMinTogether = 2;  // states that both must have

bool isHeavy(AgentClass agent_class) {
  return agent_class == AgentClass::kTruck || agent_class == AgentClass::kBus ||
         agent_class == AgentClass::kConstructionVehicle;
}

/// A quick test before the states are compared.
bool mayBeOne(AgentClass agent, AgentClass other) {
  return agent == AgentClass::kTrailer || other == AgentClass::kTrailer ||
         (isHeavy(agent) && isHeavy(other));
}

/// Returns the largest gap (m) between the boxes of `agent` and `other` as one vehicle, in the
/// order of driving for a trailer; 0 if they cannot be one.
double largestGap(const Track& agent, const Track& other, const Pose2& seen) {
  const bool is_trailer = agent.agent_class == AgentClass::kTrailer;
  if (is_trailer || other.agent_class == AgentClass::kTrailer) {
    const bool fits = isCarLike(is_trailer ? other.agent_class : agent.agent_class);
    return fits && (seen.x > 0.0) == is_trailer ? kDrawbar : 0.0;
  }
  return isHeavy(agent.agent_class) && isHeavy(other.agent_class) ? kSplit : 0.0;
}

bool areTogether(const Track& agent, const Track& other) {
  std::size_t together = 0;
  for (const AgentState& state : agent.states) {
    const auto found = stateAt(other, state.time, 0.0);
    if (!found) continue;
    const Pose2 seen = relativeTo(state.pose, found->pose);
    const double gap = largestGap(agent, other, seen);
    const bool is_in_line = std::abs(seen.x) > std::abs(seen.y);
    if (gap == 0.0 || !is_in_line) return false;
    if (distance(boxAt(agent, state.pose), boxAt(other, found->pose)) > gap) return false;
    ++together;
  }
  return together >= kMinTogether;
}

}  // namespace

const Track* hitchedTo(const Track& agent, const std::vector<Track>& agents) {
  const auto found = std::find_if(agents.begin(), agents.end(), [&](const Track& other) {
    return other.id != agent.id && mayBeOne(agent.agent_class, other.agent_class) &&
           areTogether(agent, other);
  });
  return found == agents.end() ? nullptr : &*found;
}

}  // namespace forge
