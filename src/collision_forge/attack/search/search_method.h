#pragma once

#include <memory>

#include "collision_forge/attack/search/attack_method.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/search/pattern_predictor.h"
#include "collision_forge/attack/search/realizer.h"

namespace forge {

/// The default method: predicts patterns, then a realiser drives a recorded or added attacker into
/// one of them. Both stages may run in other nodes; AttackJudge checks every attack in the same
/// way. If the predictor fails without a future, its status is returned. For a request with
/// `hidden_by` or `queue`, searches attacks without them and adds the support vehicles.
class SearchMethod : public AttackMethod {
 public:
  /// Uses SearchRealizer.
  SearchMethod(const AttackOptions& options, std::shared_ptr<const PatternPredictor> predictor);
  /// Uses `realizer`. Neither pointer may be null.
  SearchMethod(const AttackOptions& options, std::shared_ptr<const PatternPredictor> predictor,
               std::shared_ptr<const TrajectoryRealizer> realizer);

  Attack answer(const Moment& moment, const CollisionRequest& request) const override;

 private:
  /// An attack and the future that it was searched in.
  struct Found {
    Attack attack;
    Future future;
  };
  Found search(const Moment& moment, const CollisionRequest& request) const;
  Found searchHidden(const Moment& moment, const CollisionRequest& request) const;
  Found hiddenBy(const Found& found, const Moment& moment, const CollisionRequest& request) const;
  Attack queued(const Found& found, const Moment& moment, const CollisionRequest& request) const;

  AttackOptions options_;
  std::shared_ptr<const PatternPredictor> predictor_;
  std::shared_ptr<const TrajectoryRealizer> realizer_;
};

}  // namespace forge
