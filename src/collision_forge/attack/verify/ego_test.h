#pragma once

#include <map>
#include <optional>

#include "collision_forge/attack/verify/verification.h"

namespace forge {

/// Tests one attacker's trajectory against an ego that is driven (or replayed) now, as it comes.
/// States that are not after the ones before are left out. Not thread-safe.
class EgoTest {
 public:
  /// The trajectory must have points; throws std::invalid_argument otherwise.
  EgoTest(AttackerTrajectory trajectory, const CollisionRequest& request, const EgoVehicle& ego);

  /// What it drives now: the attacker reacts to the ego. All that was seen is kept. Throws as the
  /// constructor.
  void changeTrajectory(AttackerTrajectory trajectory);

  /// What counts as the crash, where that is told later than the trajectory.
  void changeRequest(const CollisionRequest& request) { request_ = request; }

  /// Middle of the ego's box; its poses tell its velocity. States from before the trajectory's
  /// start may be given.
  void addEgo(const AgentState& state);
  /// Everybody else at one time, one state each; who is not usable (isUsable()) is left out.
  void addAgents(const std::vector<Track>& agents);

  /// The verification against what was driven: as soon as the attacker has touched the ego, the
  /// others are known up to then and two states of the ego tell its speed then, or when the
  /// trajectory has ended; empty before, and for an ego whose first state is later than the
  /// trajectory's start. What comes after that would not change it.
  std::optional<CollisionReport> outcome(const LaneIndex& lanes,
                                         const VerificationOptions& options) const;

 private:
  AttackerTrajectory trajectory_;
  CollisionRequest request_;
  Track ego_;
  std::map<std::string, Track> agents_;
  double agents_until_ = 0.0;  // time of their newest state
};

}  // namespace forge
