#pragma once

#include <memory>

#include "collision_forge/attack/attack_method.h"
#include "collision_forge/attack/options.h"
#include "collision_forge/attack/pattern_predictor.h"

namespace forge {

/// The suite's own method: predicts patterns, then searches for an attack that realises one of them
/// and verifies it (realize()).
class SearchMethod : public AttackMethod {
 public:
  SearchMethod(const AttackOptions& options, std::shared_ptr<const PatternPredictor> predictor);

  Realization answer(const Moment& moment, const CollisionRequest& request) const override;

 private:
  AttackOptions options_;
  std::shared_ptr<const PatternPredictor> predictor_;
};

}  // namespace forge
