#include "collision_forge/attack/search/queued_vehicle.h"

#include <algorithm>
#include <cmath>

#include "collision_forge/attack/forecast/motion_estimate.h"

namespace forge {
namespace {

// Own choices, as all numbers here.
constexpr double kFarthestGap = 6.0;  // m between the boxes of attacker and queued vehicle
constexpr double kGaps[] = {2.0, 1.2, 3.0, 4.5, kFarthestGap};  // m, tried in this order
constexpr double kSameLane = 1.5;                               // m between the paths of both
constexpr double kLaneDistance = 2.0;  // m from the attacker to the middle of its lane
constexpr double kLaneHeading = 0.6;   // rad

/// Returns the pose `distance` m ahead of `from` along its lane, at the same distance from the
/// middle of the lane; straight ahead without a lane.
Pose2 ahead(const Pose2& from, double distance, const LaneIndex& lanes) {
  const auto matches = lanes.lanesNear(from, kLaneDistance, kLaneHeading);
  if (matches.empty()) return compose(from, {distance, 0.0, 0.0});
  const LaneMatch& match = matches.front();
  const Polyline path = lanes.pathAhead(match.lane, match.projection.arc_length, distance);
  const Pose2 offset = relativeTo(path.poseAt(0.0), from);
  return compose(path.poseAt(distance), {0.0, offset.y, 0.0});
}

}  // namespace

bool isQueued(const HidingInput& input) {
  const AttackerTrajectory& attacker = input.attacker;
  const Pose2 place = poseAt(attacker, input.contact);
  return std::any_of(
      input.future.agents.begin(), input.future.agents.end(), [&](const Track& agent) {
        const auto state = stateAt(agent, input.contact);
        if (agent.id == attacker.attacker_id || !isVehicle(agent.agent_class) || !state)
          return false;
        if (state->velocity.norm() >= kStandstillSpeed) return false;
        const Pose2 there = relativeTo(place, state->pose);
        const double gap = there.x - 0.5 * (attacker.size.length + agent.size.length);
        return gap > 0.0 && gap <= kFarthestGap && std::abs(there.y) <= kSameLane;
      });
}

std::optional<SupportVehicle> findQueuedVehicle(const HidingInput& input,
                                                const AttackOptions& options, Status& refusal) {
  const HidingSearch search(input);
  const AttackerTrajectory& attacker = input.attacker;
  const Pose2 place = poseAt(attacker, input.contact);
  const auto& kinds = options.added.kinds;
  const auto car = std::find_if(kinds.begin(), kinds.end(), [](const AddedKind& kind) {
    return kind.agent_class == AgentClass::kCar;
  });
  const BoxSize size{car->length, car->width};
  const RecordedTraffic& traffic = search.traffic();
  const double until = attacker.points.back().time - input.past.now;
  const int last =
      std::min(traffic.lastInstant(), static_cast<int>(std::ceil(until / traffic.interval())));
  const auto isFree = [&](const Pose2& pose) {
    for (int instant = traffic.firstInstant(); instant <= last; ++instant) {
      if (traffic.touches(pose, size, instant, kSupportClearance)) return false;
    }
    return true;
  };
  refusal = {StatusCode::kRoadDoesNotAllow, "every place ahead of the attacker is off the road"};
  for (const double gap : kGaps) {
    const Pose2 pose = ahead(place, 0.5 * (attacker.size.length + size.length) + gap, input.lanes);
    if (!search.isOnRoad({pose, size})) continue;
    if (isFree(pose)) {
      return SupportVehicle{SupportRole::kQueue,
                            standingVehicle(search.newId("queue", 0), *car, pose, input)};
    }
    refusal = {StatusCode::kNoAttackWithinLimits, "it would stand in the way of another agent"};
  }
  return std::nullopt;
}

}  // namespace forge
