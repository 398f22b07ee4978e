#pragma once

#include <optional>

#include "collision_forge/attack/drivers/driver_models.h"

namespace forge {

class Section;

/// Limits that keep a test fair.
struct FairnessOptions {
  double reaction_time = 0.0;   ///< s from observation to changed motion
  double aggressiveness = 0.0;  ///< share 0.1..1 of the class limits that new plans use
  double avoidable_for = 0.0;   ///< s after t0 during which the ego can still avoid the crash
  /// A driver of this model in the ego's place must avoid the crash; empty: not required.
  std::optional<DriverModel> avoidable_by;
};

/// config/adaptive.yaml
struct AdaptiveOptions {
  double period = 0.0;       ///< s between two replans, at least
  double commit_time = 0.0;  ///< s before the latest contact time at which replanning ends
  int ego_samples = 0;       ///< predicted ego futures per update step
  double evade_time =
      0.0;  ///< s; a predicted contact with another agent this soon aborts the attack
  double lost_after = 0.0;     ///< s without the ego before the attack is aborted
  double max_ego_speed = 0.0;  ///< m/s; a faster ego has jumped
  FairnessOptions fairness;
};

/// Reads the struct from its section. Throws ConfigError for a missing key or a value out of range.
void readOptions(Section& section, AdaptiveOptions& options);

}  // namespace forge
