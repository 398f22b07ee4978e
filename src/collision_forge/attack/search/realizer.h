#pragma once

#include <vector>

#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/search/search_task.h"
#include "collision_forge/attack/verify/verification.h"
#include "collision_forge/base/scene/attack.h"

namespace forge {

/// Input of a realiser. Holds references: the referenced objects must outlive it.
struct RealizationTask {
  const std::vector<CollisionPattern>& patterns;  ///< most promising first
  /// scene, futures and request; the snapshot must contain the attackers
  const VerificationInput& input;
  bool exact = false;  ///< require the contact at one of the patterns (isExact())
  /// Paths of attackers by id, used instead of the paths along their lanes; for plausible attackers
  /// only.
  const AttackerPaths& ways = kNoPaths;
  /// how plausible attackers are searched; ignored for others
  SearchedMotion motion = SearchedMotion::kByRoutes;
};

/// Searches from the patterns (searchAttacks()) and returns the first attack, best first, that
/// AttackJudge accepts; without one (also without patterns), AttackJudge::refusal(). Deterministic
/// in its arguments. Throws InputError if a pattern's attacker is not in the snapshot, its time is
/// not after t0, a number is not finite, or the tolerance is negative.
Attack realize(const RealizationTask& task, const AttackOptions& options);

/// Interface: drives attackers into collision patterns, the second stage of SearchMethod. Extension
/// point (also as ROS service realize_trajectory). Implementations must be immutable: one object is
/// used from many threads at once.
class TrajectoryRealizer {
 public:
  virtual ~TrajectoryRealizer() = default;

  /// Returns an attack that AttackJudge accepts, or a status other than kOk with the reason. Called
  /// on the caller's thread several times per request: for recorded and added attackers, and for
  /// each SearchedMotion. Must be deterministic in its arguments. May throw InputError for unusable
  /// patterns; must not modify or keep the task's references.
  virtual Attack realize(const RealizationTask& task) const = 0;
};

/// Calls realize() in this process.
class SearchRealizer : public TrajectoryRealizer {
 public:
  explicit SearchRealizer(const AttackOptions& options) : options_(options) {}

  Attack realize(const RealizationTask& task) const override {
    return forge::realize(task, options_);
  }

 private:
  AttackOptions options_;
};

}  // namespace forge
