#pragma once

namespace forge {

class Section;

/// What keeps a test fair.
struct FairnessOptions {
  double reaction_time = 0.0;
  double aggressiveness = 0.0;
  double avoidable_for = 0.0;
};

/// config/adaptive.yaml, where each number's unit and source stand.
struct AdaptiveOptions {
  double period = 0.0;
  double commit_time = 0.0;
  int ego_samples = 0;
  double evade_time = 0.0;
  double lost_after = 0.0;
  double max_ego_speed = 0.0;
  FairnessOptions fairness;
};

void readOptions(Section& section, AdaptiveOptions& options);

}  // namespace forge
