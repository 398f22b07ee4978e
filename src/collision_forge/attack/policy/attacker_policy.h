#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/scene_history.h"

namespace forge {

/// Phase of an attack.
enum class AttackerPhase {
  kAttacking,  ///< drives towards the crash and may replan
  kCommitted,  ///< drives towards the crash, too late to replan
  kDrivingOn,  ///< aborted or past the crash: normal traffic
};
/// Returns "attacking", "committed" or "driving_on".
const char* toString(AttackerPhase phase);
/// Returns the phase of a name as toString() spells it; nullopt for another name.
std::optional<AttackerPhase> attackerPhaseFromString(const std::string& name);

/// One decision of an attacker and the motion planned with it.
struct AttackerPlan {
  double seen = 0.0;  ///< s, scene clock: frame on which the decision is based
  double from = 0.0;  ///< s, scene clock: start of the planned motion
  /// phase after the decision
  AttackerPhase phase = AttackerPhase::kAttacking;
  std::string reason;  ///< for people, for instance "too late to replan"
  /// from `from` to the end; empty: the previous plan continues
  std::vector<TrajectoryPoint> points;
};

/// Returns the initial plan: all points of `trajectory`, which must have points; `seen` and `from`
/// are the time of the first point.
AttackerPlan firstPlan(const AttackerTrajectory& trajectory, AttackerPhase phase);

/// Interface: drives one attacker through one attack, one frame at a time. Extension point for
/// attackers that react to the scene. A policy must be deterministic: the same frames give the same
/// trajectory. One object is used by one thread at a time and need not be thread-safe. Users:
/// LiveAttacker (subscriber thread, under its mutex), planner tests (simulation thread) and
/// driveOverRecording().
class AttackerPolicy {
 public:
  virtual ~AttackerPolicy() = default;

  /// Returns an independent copy with the same observations and plan. Called when a simulation is
  /// branched or restarted. Must not share mutable state with the original.
  virtual std::unique_ptr<AttackerPolicy> clone() const = 0;

  /// Update step: called once per frame (ego and all agents at its time, nothing later; box
  /// centres, map frame), times ascending, on the thread of the scene subscriber or simulation,
  /// which waits for it: it must take less than the frame interval. Frames not later than the last
  /// one must be ignored. `seen.ego` is not finite if the ego was not observed. Should not throw,
  /// because an exception ends the whole simulation: abort the attack instead.
  virtual void observe(const Frame& seen) = 0;

  /// Returns the motion from t0: driven up to the newest frame, planned after it. Must have points,
  /// must never change the part before the newest frame, and must not throw. Called after every
  /// update step; the reference must stay valid until the next observe().
  virtual const AttackerTrajectory& trajectory() const = 0;

  /// Returns the phase after the newest update step. Must not throw.
  virtual AttackerPhase phase() const = 0;

  /// Returns the initial plan and all decisions since, in order. May only grow. Must not throw.
  virtual const std::vector<AttackerPlan>& plans() const = 0;
};

/// The built-in policies: kFixed is FixedAttacker, which drives its first plan; kAdaptive is
/// AdaptiveAttacker, which replans as the ego moves.
enum class PolicyKind { kFixed, kAdaptive };
/// Returns "fixed" or "adaptive".
const char* toString(PolicyKind kind);
/// Returns the policy of a name as toString() spells it; nullopt for another name.
std::optional<PolicyKind> policyKindFromString(const std::string& name);

/// Drives a given trajectory, whatever happens; its phase is always kCommitted.
class FixedAttacker : public AttackerPolicy {
 public:
  /// `trajectory` must have points.
  explicit FixedAttacker(AttackerTrajectory trajectory) : trajectory_(std::move(trajectory)) {
    plans_.push_back(firstPlan(trajectory_, AttackerPhase::kCommitted));
  }

  std::unique_ptr<AttackerPolicy> clone() const override {
    return std::make_unique<FixedAttacker>(*this);
  }
  void observe(const Frame& /*seen*/) override {}
  const AttackerTrajectory& trajectory() const override { return trajectory_; }
  AttackerPhase phase() const override { return AttackerPhase::kCommitted; }
  const std::vector<AttackerPlan>& plans() const override { return plans_; }

 private:
  AttackerTrajectory trajectory_;
  std::vector<AttackerPlan> plans_;
};

}  // namespace forge
