#pragma once

#include <map>
#include <optional>

#include "collision_forge/attack/verify/verification.h"

namespace forge {

/// Verifies one attacker trajectory against an ego that is driven or replayed live, state by state.
/// Ignores states of a vehicle that are not later than its previous one, so a test cannot be
/// restarted: make a new object. Not thread-safe.
class EgoTest {
 public:
  /// Only the size of `ego` is used. Throws std::invalid_argument if `trajectory` has no points.
  EgoTest(AttackerTrajectory trajectory, const CollisionRequest& request, const EgoVehicle& ego);

  /// Replaces the trajectory of an attacker that reacts to the ego; all states added so far are
  /// kept. Throws std::invalid_argument if `trajectory` has no points.
  void changeTrajectory(AttackerTrajectory trajectory);

  /// Replaces the request, for a crash definition that arrives later than the trajectory; states
  /// are kept.
  void changeRequest(const CollisionRequest& request) { request_ = request; }

  /// Adds an ego state; its pose is the box centre, global map frame. Its velocity is derived from
  /// the poses. The first state must not be later than the trajectory's first point, else outcome()
  /// stays empty.
  void addEgo(const AgentState& state);
  /// Adds the other agents (box centres, global map frame) at one time, one state each; the
  /// attacker's own track, if it is among them, gives its past up to t0. Agents that are not usable
  /// (isUsable()) are ignored.
  void addAgents(const std::vector<Track>& agents);

  /// Returns the report of verify() on the driven states once later states cannot change it: the
  /// ego's states reach the trajectory's last point, or the attacker touched the ego, the other
  /// agents are known up to the contact, and two ego states fix its velocity there. Empty before,
  /// and if the first ego state is later than the trajectory's first point. t0 is the time of that
  /// point. Throws as verify().
  std::optional<CollisionReport> outcome(const LaneIndex& lanes,
                                         const VerificationOptions& options) const;

 private:
  AttackerTrajectory trajectory_;
  CollisionRequest request_;
  Track ego_;
  std::map<std::string, Track> agents_;
  double agents_until_ = 0.0;  // s, time of the newest agent state
};

}  // namespace forge
