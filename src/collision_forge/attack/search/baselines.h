#pragma once

#include <memory>
#include <string>
#include <utility>

#include "collision_forge/attack/search/attack_method.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/search/pattern_predictor.h"

/// What attackers without a search drive, from now to `search.tail` seconds after the time asked
/// for, a point every `search.step` seconds.
namespace forge {

/// The attacker keeps its speed and heading of now, those of estimateMotion(). Throws
/// std::invalid_argument for an agent that is not in the snapshot.
AttackerTrajectory constantVelocityAttacker(const std::string& attacker_id,
                                            const Snapshot& snapshot, double tta,
                                            const AttackOptions& options);

/// One quintic on each axis to where the set puts attackers of the type, as seen from the ego at
/// the time asked for, which keeps its velocity, or is as in `recorded` where that is given.
/// It comes from the side on which it is now (as seen from there), arrives with the speed it has
/// now, and no limit of a vehicle is looked at. Throws std::invalid_argument for an agent that is
/// not in the snapshot, and for a recording that ends before.
AttackerTrajectory nominalAttacker(const std::string& attacker_id, const Snapshot& snapshot,
                                   const Future* recorded, const CollisionRequest& request,
                                   const AttackOptions& options);

/// How an attacker moves along its heading where it arrives.
struct EndMotion {
  double speed = 0.0;         ///< m/s
  double acceleration = 0.0;  ///< m/s2
};

/// The same to where a pattern puts its attacker, as in the paper (arXiv 2510.12206, Sec. 3.4):
/// whatever came, and whatever a vehicle can do. Without an `end` it arrives with the speed it has
/// now.
AttackerTrajectory patternAttacker(const CollisionPattern& pattern, const Snapshot& snapshot,
                                   double tta, const AttackOptions& options,
                                   const std::optional<EndMotion>& end = std::nullopt);

// The same as methods, which know no wheels: their reports are by LimitSet::kStrict, whatever the
// request says. Without an attacker in the request they take of all candidates
// (isCandidate()) the first that is verified, else that touches the ego, else any. In history mode
// the others are expected to drive as predictFuture() says.

class ConstantVelocityMethod : public AttackMethod {
 public:
  explicit ConstantVelocityMethod(const AttackOptions& options) : options_(options) {}
  Realization answer(const Moment& moment, const CollisionRequest& request) const override;

 private:
  AttackOptions options_;
};

class NominalMethod : public AttackMethod {
 public:
  explicit NominalMethod(const AttackOptions& options) : options_(options) {}
  Realization answer(const Moment& moment, const CollisionRequest& request) const override;

 private:
  AttackOptions options_;
};

/// One quintic to the likeliest pattern, as in the paper.
class PatternQuinticMethod : public AttackMethod {
 public:
  PatternQuinticMethod(const AttackOptions& options,
                       std::shared_ptr<const PatternPredictor> predictor)
      : options_(options), predictor_(std::move(predictor)) {}
  Realization answer(const Moment& moment, const CollisionRequest& request) const override;

 private:
  AttackOptions options_;
  std::shared_ptr<const PatternPredictor> predictor_;
};

}  // namespace forge
