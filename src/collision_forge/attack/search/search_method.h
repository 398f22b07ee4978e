#pragma once

#include <memory>

#include "collision_forge/attack/search/attack_method.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/search/pattern_predictor.h"
#include "collision_forge/attack/search/realizer.h"

namespace forge {

/// The default method: predicts patterns, then a realiser drives a recorded or added attacker into
/// one of them. Both stages may run in other nodes; AttackJudge checks every attack in the same
/// way. If the predictor fails without a future, its status is returned. An added attacker is
/// preferred only if its scoreOf() is greater by AddedVehicleOptions::preference, or if no recorded
/// attacker succeeds. A request for a new attacker needs plausibility and a map with lanes, else
/// the result is kNoCandidate. For a request with `hidden_by`, searches attacks without it (from
/// either side, for kParkedVehicle also 0.3 s earlier and later; for kLeader with the manoeuvre
/// kLeadStopped unless one is requested) and adds the support vehicles that hide one; rejected if
/// neither recorded nor support vehicles hide one. For a request with `queue`, searches attacks of
/// kLeadStopped and adds a support vehicle that stands ahead of the attacker unless an agent does
/// (isQueued()); rejected if there is no place for one. Plausible attackers are searched by
/// SearchedMotion::kByRoutes first, then, except people on foot, by kAny if that finds no attack.
class SearchMethod : public AttackMethod {
 public:
  /// Uses SearchRealizer. `predictor` must not be null.
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
