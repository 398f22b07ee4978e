#pragma once

#include <vector>

namespace forge {

class Section;

/// How an attacker continues as normal traffic.
struct DriveOnOptions {
  std::vector<double> speed_shares;  ///< of its speed, 0..2, tried in order
  double back_time = 0.0;            ///< s to return to the middle of its lane
  double clearance = 0.0;            ///< m kept from all agents
};

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
  double min_gain = 0.0;       ///< gain in the search objective for a new plan
  int ways = 0;                ///< candidate paths per update step
  double min_hope = 0.0;       ///< closeness 0..1 below which the attack is aborted
  double evade_time = 0.0;     ///< s ahead in which a contact aborts the attack
  double lost_after = 0.0;     ///< s without the ego before the attack is aborted
  double max_ego_speed = 0.0;  ///< m/s; a faster ego has jumped
  int rounds = 0;              ///< of perturbations
  int perturbations = 0;       ///< per round
  DriveOnOptions drive_on;
  FairnessOptions fairness;
};

void readOptions(Section& section, AdaptiveOptions& options);

}  // namespace forge
