#pragma once

#include <vector>

namespace forge {

class Section;

/// How one drives on who does not attack.
struct DriveOnOptions {
  std::vector<double> speed_shares;
  double back_time = 0.0;
  double clearance = 0.0;
};

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
  double min_gain = 0.0;
  int ways = 0;
  double min_hope = 0.0;
  double evade_time = 0.0;
  double lost_after = 0.0;
  double max_ego_speed = 0.0;
  int rounds = 0;
  int perturbations = 0;
  DriveOnOptions drive_on;
  FairnessOptions fairness;
};

void readOptions(Section& section, AdaptiveOptions& options);

}  // namespace forge
