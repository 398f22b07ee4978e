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

/// What clips are evaluated with.
struct ClipEvaluationSetup {
  const MethodRegistry& methods;  ///< beside those of clipMethods()
  const Foresight& foresight;
  const StudyOptions& study;
};

/// A method of clipMethods() for a clip, which must outlive it, by what was learned without the
/// clip's scene; `seen_scenes`: by what was learned from all scenes, where the type is known, too.
/// Throws as MethodMaker does.
MethodMaker clipMethod(const std::string& name, const CollideClip& clip,
                       const ClipEvaluationSetup& setup, bool seen_scenes);

/// What a clip of COLLIDE asks of a method where every answer is to be judged: the clip's type,
/// time and attacker, the types told by the heading alone (rulesOfClips()), whatever the
/// confidence. What came is the clip's own recording.
class ClipQuestion {
 public:
  ClipQuestion(const CollideClip& clip, std::shared_ptr<const LaneIndex> lanes, Mode mode,
               const StudyOptions& study);

  const Moment& moment() const { return moment_; }
  const CollisionRequest& request() const { return request_; }

  /// The clip as a recording: the snapshot and the future of the moment are of it.
  const Scene& recording() const { return recording_; }

  /// Why the method is not asked, as checkRequest(); kOk where it is, always of a baseline.
  Status check(const MethodMaker& maker) const;
  /// The method's answer with that seed, verified or not.
  Realization ask(const AttackMethod& method, std::uint64_t seed) const;
  /// The same of one that `maker` made for the clip; what check() says where it is not asked.
  Realization answer(const MethodMaker& maker, const AttackMethod& method,
                     std::uint64_t seed) const;

 private:
  PredictionOptions prediction_;
  CollisionRequest request_;
  Scene recording_;
  Moment moment_;
};

}  // namespace forge
