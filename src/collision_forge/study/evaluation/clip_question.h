#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "collision_forge/attack/network/method_maker.h"
#include "collision_forge/attack/search/attack_method.h"
#include "collision_forge/attack/search/method_registry.h"
#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/io/collide/collide_clip.h"
#include "collision_forge/study/evaluation/options.h"

namespace forge {

/// References to the inputs of an evaluation on clips, which must outlive it.
struct ClipEvaluationSetup {
  const MethodRegistry& methods;   ///< configured methods; clipMethods() adds more
  const PredictionModels& models;  ///< loaded models, from which clipMethod() selects
  const StudyOptions& study;       ///< all options
};

/// Returns the maker of a method of clipMethods() for `clip`, which must outlive it. Uses models
/// trained without the clip's scene, or with `seen_scenes` the models trained on all scenes,
/// conditioned on the clip's collision type. Throws std::invalid_argument for an unknown name, as
/// MethodMaker.
MethodMaker clipMethod(const std::string& name, const CollideClip& clip,
                       const ClipEvaluationSetup& setup, bool seen_scenes);

/// The request of a COLLIDE clip for evaluations that judge every attack: the clip's type, TTA and
/// attacker, types by relative heading only (withClipRules()), minimum confidence 0. The recorded
/// future is the clip's. The const members are thread-safe.
class ClipQuestion {
 public:
  /// Keeps no reference to `clip` and `study`. `lanes`: map of the clip's city, not null. `mode`:
  /// kHistory or kReplay, the mode of request().
  ClipQuestion(const CollideClip& clip, std::shared_ptr<const LaneIndex> lanes, Mode mode,
               const StudyOptions& study);

  /// Returns the clip at t0, with its recorded future.
  const Moment& moment() const { return moment_; }
  /// Returns the clip's request, with seed 0.
  const CollisionRequest& request() const { return request_; }

  /// Returns the clip as a scene (toScene()), the source of the snapshot and the future of
  /// moment().
  const Scene& recording() const { return recording_; }

  /// Returns the status of checkRequest() for request() if the method is seeded
  /// (MethodMaker::isSeeded()), kOk for any other method.
  Status check(const MethodMaker& maker) const;
  /// Runs the method with `seed` and returns its attack, verified or not, or its rejection.
  Attack ask(const AttackMethod& method, std::uint64_t seed) const;
  /// Calls check(), then ask() if it returns kOk; otherwise returns a rejection with that status.
  /// `method` was made by `maker`.
  Attack answer(const MethodMaker& maker, const AttackMethod& method, std::uint64_t seed) const;

 private:
  PredictionOptions prediction_;
  CollisionRequest request_;
  Scene recording_;
  Moment moment_;
};

}  // namespace forge
