#pragma once

#include <string>
#include <vector>

#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/study/evaluation/options.h"

namespace forge {

/// One value of one control, asked for in place of all that a request of a list asks for.
struct ControlQuestion {
  std::string name;  ///< of the request, its line in the list
  SceneRequest asked;
  std::string control;  ///< "none", or as the fields of a list: "choice", "attacker_class", ...
  std::string value;    ///< "any" of none; of a band its ends, "0.25 to 0.5"
};

/// Of a request of a list, which gives scene, now, type, TTA, seed and crash: one without any
/// control, then one for each value of each control alone, of the manoeuvres those of the type. All
/// in replay mode, where the future is the recorded one and every answer can be held against it.
std::vector<ControlQuestion> controlQuestions(const std::string& name, const SceneRequest& listed,
                                              const ControlOptions& options);

}  // namespace forge
