#pragma once

#include <memory>
#include <string>
#include <utility>

#include "collision_forge/attack/search/attack_method.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/search/pattern_predictor.h"

/// Attackers of the baselines, which do not search. Trajectories go from t0 to a little after the
/// requested contact time, at the search's time step.
namespace forge {

/// The attacker keeps its speed and heading at t0 (estimateMotion()). Throws std::invalid_argument
/// if the attacker is not in the snapshot. `tta` in s.
AttackerTrajectory constantVelocityAttacker(const std::string& attacker_id,
                                            const Snapshot& snapshot, double tta,
                                            const AttackOptions& options);

/// One quintic per axis to the pose at which COLLIDE places attackers of the type, relative to the
/// ego at the requested time: predicted at constant velocity, or recorded if `recorded` is given.
/// The attacker comes from the side on which it is at t0 and arrives with its speed at t0; vehicle
/// limits are ignored. Throws std::invalid_argument if the attacker is not in the snapshot or the
/// recording ends before.
AttackerTrajectory nominalAttacker(const std::string& attacker_id, const Snapshot& snapshot,
                                   const Future* recorded, const CollisionRequest& request,
                                   const AttackOptions& options);

/// Motion along the heading at the arrival.
struct EndMotion {
  double speed = 0.0;         ///< m/s
  double acceleration = 0.0;  ///< m/s2
};

/// One quintic per axis to the pattern's pose, as in the paper (arXiv 2510.12206, Sec. 3.4),
/// whatever the ego does and whatever a vehicle can do. Without `end` it arrives with its speed at
/// t0. Throws std::invalid_argument if the attacker is not in the snapshot.
AttackerTrajectory patternAttacker(const CollisionPattern& pattern, const Snapshot& snapshot,
                                   double tta, const AttackOptions& options,
                                   const std::optional<EndMotion>& end = std::nullopt);

// The same as methods, which know no wheels: their reports are by LimitSet::kStrict, whatever the
// request says. Without an attacker in the request they take of all candidates
// (isCandidate()) the first that is verified, else that touches the ego, else any. In history mode
// the others are expected to drive as predictFuture() says.

/// The baselines as methods. They ignore vehicle limits, so their reports use LimitSet::kStrict
/// whatever the request says. Without a requested attacker they return the first candidate
/// (isCandidate()) whose attack is verified, else one that touches the ego, else any. In history
/// mode other agents move as in predictFuture().
class ConstantVelocityMethod : public AttackMethod {
 public:
  explicit ConstantVelocityMethod(const AttackOptions& options) : options_(options) {}
  Attack answer(const Moment& moment, const CollisionRequest& request) const override;

 private:
  AttackOptions options_;
};

/// See nominalAttacker().
class NominalMethod : public AttackMethod {
 public:
  explicit NominalMethod(const AttackOptions& options) : options_(options) {}
  Attack answer(const Moment& moment, const CollisionRequest& request) const override;

 private:
  AttackOptions options_;
};

/// One quintic to the most promising pattern of `predictor`, as in the paper.
class PatternQuinticMethod : public AttackMethod {
 public:
  PatternQuinticMethod(const AttackOptions& options,
                       std::shared_ptr<const PatternPredictor> predictor)
      : options_(options), predictor_(std::move(predictor)) {}
  Attack answer(const Moment& moment, const CollisionRequest& request) const override;

 private:
  AttackOptions options_;
  std::shared_ptr<const PatternPredictor> predictor_;
};

}  // namespace forge
