#pragma once

#include <string>
#include <vector>

#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/study/evaluation/options.h"

namespace forge {

/// A request that sets exactly one control (constraint) to one value.
struct ControlQuestion {
  std::string name;     ///< line of the original request in its list
  SceneRequest asked;   ///< the request with the control
  std::string control;  ///< field name, as "choice" or "attacker_class"; "none": no control
  std::string value;    ///< value of the control, as "0.25 to 0.5" for a band; "any" for "none"
};

/// Returns the questions derived from one request: one without controls, then one per value of each
/// control, manoeuvres only of the request's type. Scene, t0, type, TTA, seed and crash definition
/// are copied from `listed`; its controls are ignored. All questions use replay mode, so that
/// attacks can be verified against the recorded future. `name` is copied to each question.
std::vector<ControlQuestion> controlQuestions(const std::string& name, const SceneRequest& listed,
                                              const ControlOptions& options);

}  // namespace forge
