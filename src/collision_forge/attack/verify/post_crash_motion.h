#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/attack/severity/severity.h"
#include "collision_forge/base/scene/attack.h"

namespace forge {

/// Motion of ego and attacker from the contact until both stand, computed from their states at the
/// contact only. Bags, images, pages, exports and the live display all use this class, so a crash
/// ends the same way in all of them.
///
/// Both keep their velocities for SeverityOptions::engagement, while their boxes overlap as much as
/// the vehicles deform. Then the impact of impactOf() changes their velocities and yaw rates, and
/// each moves as a SlidingBody; its driver brakes after AfterImpactOptions::braking_delay. If they
/// press against each other again, a plastic planarImpact() ends that. There is no suspension,
/// steering or roll-over.
class PostCrashMotion {
 public:
  /// Both states (box centres, global map frame) must have the contact time. Integrates the whole
  /// motion in steps of 0.01 s; copies share it. Throws as planarImpact().
  PostCrashMotion(const CrashedVehicle& ego, const CrashedVehicle& attacker,
                  const SeverityOptions& options);

  /// Returns the time of the contact, s, same clock as the states.
  double contactTime() const { return steps_->front().time; }
  /// Returns the time at which both vehicles have stopped, s; at most about 30 s after the contact,
  /// when the motion is cut off.
  double standTime() const { return steps_->back().time; }

  /// Returns the ego's state (box centre, global map frame) at `time` (s), interpolated linearly;
  /// before the contact, its state at the contact; after standTime(), its last pose with velocity
  /// 0.
  AgentState egoAt(double time) const;
  /// As egoAt() for the attacker.
  AgentState attackerAt(double time) const;

  const BoxSize& egoSize() const { return ego_size_; }
  const BoxSize& attackerSize() const { return attacker_size_; }

 private:
  /// Both vehicles at one time; yaws are continuous, not wrapped.
  struct Step {
    double time = 0.0;  ///< s
    AgentState ego;
    AgentState attacker;
  };

  AgentState stateAt(double time, AgentState Step::*of) const;

  BoxSize ego_size_;
  BoxSize attacker_size_;
  std::shared_ptr<const std::vector<Step>> steps_;  ///< at least one
};

/// Returns the motion after a contact of `ego` and `other`, the attacker of that motion, at
/// `contact_time` (s, clock of the tracks); empty if one of the two tracks has no state at that
/// time (to 1 us). Throws as planarImpact().
std::optional<PostCrashMotion> motionAfterContact(double contact_time, const Track& other,
                                                  const Track& ego, const SeverityOptions& options);

/// As above for the attacker of `trajectory`; empty, too, if it has no points.
std::optional<PostCrashMotion> motionAfterContact(double contact_time,
                                                  const AttackerTrajectory& trajectory,
                                                  const Track& ego, const SeverityOptions& options);

/// As above for the contact of `report`; empty if the report has no contact.
std::optional<PostCrashMotion> motionAfterContact(const CollisionReport& report,
                                                  const AttackerTrajectory& trajectory,
                                                  const Track& ego, const SeverityOptions& options);

/// The first touch of another agent by a crashed vehicle.
struct SecondaryContact {
  double time = 0.0;    ///< s, same clock as the motion
  bool is_ego = false;  ///< true: the ego touches the agent; false: the attacker does
  std::string agent_id;
};

/// Returns the agents that ego or attacker touch between the contact and standTime() if they move
/// as their tracks, sorted by time; the times are multiples of 0.05 s after the contact. Contains
/// an agent at most once per vehicle. `other_id` names the attacker, which is left out of `agents`,
/// as are agents that the vehicle overlaps at the contact already.
std::vector<SecondaryContact> secondaryContacts(const PostCrashMotion& motion,
                                                const std::string& other_id,
                                                const std::vector<Track>& agents);

}  // namespace forge
