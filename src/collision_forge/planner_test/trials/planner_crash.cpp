#include "collision_forge/planner_test/trials/planner_crash.h"

#include "collision_forge/base/scene/find_track.h"

namespace forge {
namespace {

/// Returns the touched vehicle's motion: as simulated if it reacted, else as recorded.
const Track* findOther(const RolloutOutcome& outcome, const std::vector<Track>& recorded) {
  const std::string& id = outcome.contact->other_id;
  const Track* driven = findTrack(outcome.others, id);
  return driven != nullptr ? driven : findTrack(recorded, id);
}

}  // namespace

std::optional<PlannerCrash> crashOf(const RolloutOutcome& outcome, const BoxSize& ego_size,
                                    const std::vector<Track>& recorded,
                                    const SeverityOptions& options) {
  if (!outcome.contact) return std::nullopt;
  const AttackerTrajectory& driven = outcome.attacker;
  const Track attacker{driven.attacker_id, driven.agent_class, driven.size,
                       toStates(driven.points)};
  const Track* other = outcome.contact->is_attacker ? &attacker : findOther(outcome, recorded);
  if (other == nullptr) return std::nullopt;
  const Track ego{kEgoId, AgentClass::kCar, ego_size, toStates(outcome.driven)};
  const auto motion = motionAfterContact(outcome.contact->time, *other, ego, options);
  if (!motion) return std::nullopt;
  return PlannerCrash{*other, *motion};
}

}  // namespace forge
