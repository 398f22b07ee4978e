#pragma once

#include <memory>
#include <string>
#include <utility>

#include "collision_forge/attack/search/attack_method.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/search/pattern_predictor.h"

/// Attackers of the baselines, which do not search. Trajectories have points from t0 to `tta` plus
/// SearchOptions::tail (rounded to whole steps), SearchOptions::step apart; all poses are box
/// centres, map frame.
namespace forge {

/// The attacker keeps its speed and heading at t0 (estimateMotion()) until options.search.tail
/// seconds after `tta` (s, from t0). Throws std::invalid_argument if the attacker is not in the
/// snapshot.
AttackerTrajectory constantVelocityAttacker(const std::string& attacker_id,
                                            const Snapshot& snapshot, double tta,
                                            const AttackOptions& options);

/// One quintic per axis to the pose at which COLLIDE places attackers of the type, NominalOptions,
/// relative to the ego at the requested time: predicted at constant speed and heading, or recorded
/// if `recorded` is not null. Straight on from there. The attacker comes from the side on which it
/// is at t0 and arrives with its speed at t0; vehicle limits are ignored. Throws
/// std::invalid_argument if the attacker is not in the snapshot or the recording ends before.
AttackerTrajectory nominalAttacker(const std::string& attacker_id, const Snapshot& snapshot,
                                   const Future* recorded, const CollisionRequest& request,
                                   const AttackOptions& options);

/// One quintic per axis to the pattern's pose `tta` s after t0, as in the paper (arXiv 2510.12206,
/// Sec. 3.4), whatever the ego does and whatever a vehicle can do. The attacker arrives with its
/// speed at t0 and goes straight on. Throws std::invalid_argument if the attacker is not in the
/// snapshot.
AttackerTrajectory patternAttacker(const CollisionPattern& pattern, const Snapshot& snapshot,
                                   double tta, const AttackOptions& options);

/// The baselines as methods. They ignore vehicle limits, so their reports use LimitSet::kStrict
/// whatever the request says. Without a requested attacker ConstantVelocityMethod and NominalMethod
/// return the first candidate (isCandidate()) whose attack is verified, else one that touches the
/// ego, else any. In history mode other agents move as in predictFuture(). ConstantVelocityMethod:
/// see constantVelocityAttacker().
class ConstantVelocityMethod : public AttackMethod {
 public:
  explicit ConstantVelocityMethod(const AttackOptions& options) : options_(options) {}
  Attack answer(const Moment& moment, const CollisionRequest& request) const override;

 private:
  AttackOptions options_;
};

/// Baseline of nominalAttacker().
class NominalMethod : public AttackMethod {
 public:
  explicit NominalMethod(const AttackOptions& options) : options_(options) {}
  Attack answer(const Moment& moment, const CollisionRequest& request) const override;

 private:
  AttackOptions options_;
};

/// One quintic to the first (most promising) pattern of `predictor`, as in the paper:
/// patternAttacker(). Returns the predictor's status if that is not kOk.
class PatternQuinticMethod : public AttackMethod {
 public:
  /// `predictor` must not be null.
  PatternQuinticMethod(const AttackOptions& options,
                       std::shared_ptr<const PatternPredictor> predictor)
      : options_(options), predictor_(std::move(predictor)) {}
  Attack answer(const Moment& moment, const CollisionRequest& request) const override;

 private:
  AttackOptions options_;
  std::shared_ptr<const PatternPredictor> predictor_;
};

}  // namespace forge
