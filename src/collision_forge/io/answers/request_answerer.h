#pragma once

#include "collision_forge/attack/network/method_maker.h"
#include "collision_forge/attack/policy/options.h"
#include "collision_forge/io/logs/scene_source.h"
#include "collision_forge/io/scenarios/scenario_file.h"

namespace forge {

/// Answers requests over recorded scenes. Thread-safe; the same request gives the same answer in
/// every process. What was learned from the scene itself is not used.
class RequestAnswerer {
 public:
  /// `scenes` must outlive it; `crash` is what counts in every request.
  RequestAnswerer(SceneSource& scenes, MethodMaker method, CrashDefinition crash,
                  const EgoVehicle& ego, const AdaptiveOptions& adaptive);

  /// generateCollision() at the frame of the request, in adaptive mode answerAdaptively() without
  /// misses; the status of momentAt() where there is none.
  /// Throws as SceneSource::at() does.
  Scenario answer(const SceneRequest& asked) const;

 private:
  SceneSource& scenes_;
  MethodMaker method_;
  CrashDefinition crash_;
  EgoVehicle ego_;
  AdaptiveOptions adaptive_;
};

}  // namespace forge
