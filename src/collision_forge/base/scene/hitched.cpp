#include "collision_forge/base/scene/hitched.h"

#include <algorithm>
#include <cmath>

namespace forge {
namespace {

constexpr double kDrawbar = 0.5;         // m between the boxes of two parts
constexpr std::size_t kMinTogether = 2;  // states that both must have

bool isHeavy(AgentClass agent_class) {
  return agent_class == AgentClass::kTruck || agent_class == AgentClass::kBus ||
         agent_class == AgentClass::kConstructionVehicle;
}

bool canBeOneVehicle(AgentClass agent, AgentClass other) {
  if (agent == AgentClass::kTrailer) return isCarLike(other);
  if (other == AgentClass::kTrailer) return isCarLike(agent);
  return isHeavy(agent) && isHeavy(other);
}

/// Returns true if `other` is within kDrawbar, before or behind rather than beside.
bool isInLine(const OrientedBox& agent, const OrientedBox& other) {
  const Pose2 seen = relativeTo(agent.center, other.center);
  return std::abs(seen.x) > std::abs(seen.y) && distance(agent, other) <= kDrawbar;
}

bool areTogether(const Track& agent, const Track& other) {
  std::size_t together = 0;
  for (const AgentState& state : agent.states) {
    const auto found = stateAt(other, state.time, 0.0);
    if (!found) continue;
    if (!isInLine(boxAt(agent, state.pose), boxAt(other, found->pose))) return false;
    ++together;
  }
  return together >= kMinTogether;
}

}  // namespace

const Track* hitchedTo(const Track& agent, const std::vector<Track>& agents) {
  const auto found = std::find_if(agents.begin(), agents.end(), [&](const Track& other) {
    return other.id != agent.id && canBeOneVehicle(agent.agent_class, other.agent_class) &&
           areTogether(agent, other);
  });
  return found == agents.end() ? nullptr : &*found;
}

}  // namespace forge
