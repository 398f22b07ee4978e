#pragma once

#include "collision_forge/attack/options.h"
#include "collision_forge/data/options.h"
#include "collision_forge/policy/options.h"
#include "collision_forge/scene/crash_definition.h"

namespace forge {

/// The options by which attacks on recorded scenes are made and judged.
struct AnswerOptions : DataOptions, ModelOptions {
  CrashDefinition crash;
  AttackOptions attack;
  AdaptiveOptions adaptive;
};

}  // namespace forge
