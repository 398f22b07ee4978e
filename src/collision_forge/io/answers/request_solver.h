#pragma once

#include "collision_forge/attack/network/method_maker.h"
#include "collision_forge/attack/policy/options.h"
#include "collision_forge/io/logs/scene_source.h"
#include "collision_forge/io/scenarios/scenario_file.h"

namespace forge {

/// Generates the attack for each request on recorded scenes. Thread-safe and deterministic across
/// processes. Uses only models that were trained without the requested scene.
class RequestSolver {
 public:
  /// `scenes` must outlive this object. `crash` replaces the crash definition of every request.
  RequestSolver(SceneSource& scenes, MethodMaker method, CrashDefinition crash,
                const EgoVehicle& ego, const AdaptiveOptions& adaptive);

  /// Returns the result of generateCollision() at the frame of the request, whose type kAny becomes
  /// the type of the attack; in adaptive mode, of
  /// requestAdaptively() followed by rejectMisses(). If no frame is at that time, returns the
  /// status of momentAt(). Throws as SceneSource::at().
  Scenario answer(const SceneRequest& asked) const;

 private:
  SceneSource& scenes_;
  MethodMaker method_;
  CrashDefinition crash_;
  EgoVehicle ego_;
  AdaptiveOptions adaptive_;
};

}  // namespace forge
