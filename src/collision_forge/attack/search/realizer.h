#pragma once

#include <vector>

#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/search/search_task.h"
#include "collision_forge/attack/verify/verification.h"
#include "collision_forge/base/scene/attack.h"

namespace forge {

/// What is to be driven.
struct RealizationTask {
  const std::vector<CollisionPattern>& patterns;  ///< most promising first
  const VerificationInput& input;
  bool exact = false;                  ///< the contact is at one of the patterns (isExact())
  const AttackerWays& ways = kNoWays;  ///< of believable attackers, as the next
  SearchedMotion motion = SearchedMotion::kByRoutes;
};

/// Searches (searchAttacks()) from the patterns, and returns the first attack that AttackJudge
/// accepts, the best first, with the pattern that it came from. Same input and seed, same answer.
/// Throws InputError for a pattern whose attacker is not in the snapshot, whose time is not after
/// now, or with a number that is not finite or a tolerance below 0.
Realization realize(const RealizationTask& task, const AttackOptions& options);

/// Drives attackers into patterns. Implementations are immutable and may be used from many threads.
class TrajectoryRealizer {
 public:
  virtual ~TrajectoryRealizer() = default;

  /// An attack that AttackJudge accepts, or why there is none.
  virtual Realization realize(const RealizationTask& task) const = 0;
};

/// realize(), in this process.
class SearchRealizer : public TrajectoryRealizer {
 public:
  explicit SearchRealizer(const AttackOptions& options) : options_(options) {}

  Realization realize(const RealizationTask& task) const override {
    return forge::realize(task, options_);
  }

 private:
  AttackOptions options_;
};

}  // namespace forge
