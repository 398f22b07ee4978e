#pragma once

#include "collision_forge/attack/network/method_maker.h"
#include "collision_forge/attack/policy/options.h"
#include "collision_forge/io/logs/scene_source.h"
#include "collision_forge/io/scenarios/scenario_file.h"

namespace forge {

/// Generates the attack for each request on recorded scenes. Thread-safe and deterministic across
/// processes. Uses only models that were trained without the requested scene, where there are any.
class RequestSolver {
 public:
  /// `scenes` must outlive this object. `method` makes the attack method. `crash` replaces the
  /// crash definition of every request. Only the `center_offset` of `ego` is used: the box comes
  /// from the scene.
  RequestSolver(SceneSource& scenes, MethodMaker method, CrashDefinition crash,
                const EgoVehicle& ego, const AdaptiveOptions& adaptive);

  /// Returns the request with its result, `Scenario::answer`: in history and replay mode, the
  /// result of generateCollision() at the frame at `asked.now`; in adaptive mode, of
  /// requestAdaptively() followed by rejectMisses(), with `Scenario::plans`. The returned request
  /// has the type of the attack instead of kAny; its other fields, also its crash definition, stay
  /// as in `asked`. A request that is rejected has a status other than kOk; if no frame is at
  /// `asked.now`, it is the status of momentAt(), and all other fields of the attack keep their
  /// defaults. Throws as SceneSource::at().
  Scenario answer(const SceneRequest& asked) const;

 private:
  SceneSource& scenes_;
  MethodMaker method_;
  CrashDefinition crash_;
  EgoVehicle ego_;
  AdaptiveOptions adaptive_;
};

}  // namespace forge
