#pragma once

#include <optional>

#include "collision_forge/attack/drivers/driver_models.h"

namespace forge {

class Section;

/// Limits that keep a test fair. Section `fairness` of config/adaptive.yaml.
struct FairnessOptions {
  double reaction_time = 0.0;  ///< s from an observation to the first motion that depends on it
  /// share 0.1..1 of the class limits (accelerations, jerk, steering rate) that new plans use
  double aggressiveness = 0.0;
  /// s after t0 for which the ego can still avoid a fair crash; shorter: the hit is unfair
  double avoidable_for = 0.0;
  /// A driver of this model in the ego's place must avoid the crash (driveCarefully()); empty,
  /// "any" in the file: not required.
  std::optional<DriverModel> avoidable_by;
};

/// config/adaptive.yaml, options of AdaptiveAttacker
struct AdaptiveOptions {
  double period = 0.0;  ///< s, least time between two update steps that may replan
  /// s before the latest allowed contact time (requested time plus tolerance) at which replanning
  /// ends
  double commit_time = 0.0;
  int ego_samples = 0;  ///< predicted ego futures per update step
  /// s; a predicted contact with another agent this soon aborts an attack that hits the ego in no
  /// predicted future
  double evade_time = 0.0;
  double lost_after = 0.0;     ///< s without an observation of the ego before the attack is aborted
  double max_ego_speed = 0.0;  ///< m/s; an ego whose positions imply more has jumped: aborted
  FairnessOptions fairness;
};

/// Reads the struct from its section. Throws ConfigError for a missing key or a value out of range.
void readOptions(Section& section, AdaptiveOptions& options);

}  // namespace forge
