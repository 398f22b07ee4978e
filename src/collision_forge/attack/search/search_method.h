#pragma once

#include <memory>

#include "collision_forge/attack/search/attack_method.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/search/pattern_predictor.h"
#include "collision_forge/attack/search/realizer.h"

namespace forge {

/// The suite's own method: predicts patterns, then lets a realiser drive an attacker into one of
/// them, recorded or added. Either may be another node's: what the two return is judged alike
/// (AttackJudge). A predictor that declines without a future ends the search.
class SearchMethod : public AttackMethod {
 public:
  /// With SearchRealizer.
  SearchMethod(const AttackOptions& options, std::shared_ptr<const PatternPredictor> predictor);
  SearchMethod(const AttackOptions& options, std::shared_ptr<const PatternPredictor> predictor,
               std::shared_ptr<const TrajectoryRealizer> realizer);

  Realization answer(const Moment& moment, const CollisionRequest& request) const override;

 private:
  AttackOptions options_;
  std::shared_ptr<const PatternPredictor> predictor_;
  std::shared_ptr<const TrajectoryRealizer> realizer_;
};

}  // namespace forge
