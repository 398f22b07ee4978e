#pragma once

#include "collision_forge/attack/policy/options.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/base/scene/crash_definition.h"
#include "collision_forge/io/logs/options.h"

namespace forge {

/// Options for generating and judging attacks on recorded scenes.
struct AnswerOptions : DataOptions, ModelOptions {
  CrashDefinition crash;     ///< replaces the crash definition of each request
  AttackOptions attack;      ///< options of the search and of the verification
  AdaptiveOptions adaptive;  ///< options of requests in adaptive mode
};

}  // namespace forge
