#pragma once

namespace forge {

class Section;

/// Limits that keep a test fair.
struct FairnessOptions {
  double reaction_time = 0.0;   ///< s from observation to changed motion
  double aggressiveness = 0.0;  ///< share 0.1..1 of the class limits that new plans use
  double avoidable_for = 0.0;   ///< s after t0 during which the ego can still avoid the crash
};

/// config/adaptive.yaml
struct AdaptiveOptions {
  double period = 0.0;         ///< s between update steps, at least
  double commit_time = 0.0;    ///< s before the latest contact time
  int ego_samples = 0;         ///< predicted ego futures per update step
  double evade_time = 0.0;     ///< s ahead in which a contact aborts the attack
  double lost_after = 0.0;     ///< s without the ego before the attack is aborted
  double max_ego_speed = 0.0;  ///< m/s; a faster ego has jumped
  FairnessOptions fairness;
};

void readOptions(Section& section, AdaptiveOptions& options);

}  // namespace forge
