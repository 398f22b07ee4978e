#include "collision_forge/attack/verify/post_crash_motion.h"

#include <algorithm>
#include <cmath>

#include "collision_forge/base/scene/clock.h"

namespace forge {
namespace {

double brakingOf(const CrashedVehicle& vehicle, const DriveLimitOptions& options) {
  return driveLimitsOf(vehicle.agent_class, vehicle.size, options).max_braking;
}

double massOf(const CrashedVehicle& vehicle) { return vehicle.size.length * vehicle.size.width; }

/// Returns the vehicle at `time`, empty if the track has no state then. Times in messages and files
/// are rounded, so `time` may be up to kTimeEpsilon beyond an end of the track.
std::optional<CrashedVehicle> crashedAt(double time, const Track& track) {
  if (track.states.empty()) return std::nullopt;
  const double within = std::clamp(time, track.states.front().time, track.states.back().time);
  auto state = stateAt(track, within);
  if (!state || std::abs(within - time) > kTimeEpsilon) return std::nullopt;
  state->time = time;
  return CrashedVehicle{track.agent_class, track.size, *state};
}

BrakingSlide commonSlide(const CrashedVehicle& ego, const CrashedVehicle& attacker,
                         const DriveLimitOptions& options) {
  const double ego_share = massOf(ego) / (massOf(ego) + massOf(attacker));
  return {ego.state.time,
          ego_share * ego.state.velocity + (1.0 - ego_share) * attacker.state.velocity,
          std::min(brakingOf(ego, options), brakingOf(attacker, options))};
}

}  // namespace

PostCrashMotion::PostCrashMotion(const CrashedVehicle& ego, const CrashedVehicle& attacker,
                                 const DriveLimitOptions& options)
    : ego_(ego.state.pose),
      attacker_(attacker.state.pose),
      slide_(commonSlide(ego, attacker, options)) {}

AgentState PostCrashMotion::stateAfter(const Pose2& contact, double time) const {
  AgentState state = slide_.stateFrom(contact, std::max(time, contactTime()));
  state.time = time;
  return state;
}

AgentState PostCrashMotion::egoAt(double time) const { return stateAfter(ego_, time); }

AgentState PostCrashMotion::attackerAt(double time) const { return stateAfter(attacker_, time); }

std::optional<PostCrashMotion> motionAfterContact(double contact_time, const Track& other,
                                                  const Track& ego,
                                                  const DriveLimitOptions& options) {
  const auto crashed_ego = crashedAt(contact_time, ego);
  const auto crashed_other = crashedAt(contact_time, other);
  if (!crashed_ego || !crashed_other) return std::nullopt;
  return PostCrashMotion(*crashed_ego, *crashed_other, options);
}

std::optional<PostCrashMotion> motionAfterContact(double contact_time,
                                                  const AttackerTrajectory& trajectory,
                                                  const Track& ego,
                                                  const DriveLimitOptions& options) {
  const Track attacker{trajectory.attacker_id, trajectory.agent_class, trajectory.size,
                       toStates(trajectory.points)};
  return motionAfterContact(contact_time, attacker, ego, options);
}

std::optional<PostCrashMotion> motionAfterContact(const CollisionReport& report,
                                                  const AttackerTrajectory& trajectory,
                                                  const Track& ego,
                                                  const DriveLimitOptions& options) {
  if (!report.contact) return std::nullopt;
  return motionAfterContact(report.contact_time, trajectory, ego, options);
}

}  // namespace forge
