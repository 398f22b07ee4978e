#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/scene_history.h"

namespace forge {

/// What an attacker is doing.
enum class AttackerPhase {
  kAttacking,  ///< drives to the crash, and may change its plan
  kCommitted,  ///< drives to the crash; it is too late to change anything
  kDrivingOn,  ///< gave the attack up, or it is over: drives as others do
};
/// "attacking", "committed", "driving_on".
const char* toString(AttackerPhase phase);
std::optional<AttackerPhase> attackerPhaseFromString(const std::string& name);

/// What an attacker means to do, since an instant.
struct AttackerPlan {
  double seen = 0.0;  ///< s, the scene's clock: the frame that it follows from
  double from = 0.0;  ///< s, the scene's clock: driven from then on
  AttackerPhase phase = AttackerPhase::kAttacking;
  std::string reason;                   ///< for people
  std::vector<TrajectoryPoint> points;  ///< from `from` on; empty where the plan before goes on
};

/// What an attacker sets out with. The trajectory must have points.
AttackerPlan firstPlan(const AttackerTrajectory& trajectory, AttackerPhase phase);

/// Who drives an attacker, one frame at a time. One object drives one attack; a policy is
/// deterministic: the same frames give the same trajectory.
class AttackerPolicy {
 public:
  virtual ~AttackerPolicy() = default;

  /// Another that has seen the same and means to drive the same.
  virtual std::unique_ptr<AttackerPolicy> clone() const = 0;

  /// Looks at a frame: the ego and everybody else then, and nothing of what comes. Frames come in
  /// order. One that is not later than the one before is passed over.
  virtual void observe(const Frame& seen) = 0;

  /// From the attack's now on: what was driven up to the newest frame, and what will be after it.
  /// Up to the newest frame it never changes.
  virtual const AttackerTrajectory& trajectory() const = 0;

  virtual AttackerPhase phase() const = 0;

  /// The plan that it set out with and what it decided since, in order.
  virtual const std::vector<AttackerPlan>& plans() const = 0;
};

/// The policies that there are.
enum class PolicyKind { kFixed, kAdaptive };
/// "fixed", "adaptive".
const char* toString(PolicyKind kind);
std::optional<PolicyKind> policyKindFromString(const std::string& name);

/// Drives a trajectory whatever happens.
class FixedAttacker : public AttackerPolicy {
 public:
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
