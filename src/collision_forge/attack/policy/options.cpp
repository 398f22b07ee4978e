#include "collision_forge/attack/policy/options.h"

#include "collision_forge/base/config/section.h"

namespace forge {

static void readOptions(Section& section, DriveOnOptions& options) {
  options.speed_shares = section.numbers("speed_shares", 0.0, 2.0);
  options.back_time = section.positive("back_time");
  options.clearance = section.nonNegative("clearance");
}

static void readOptions(Section& section, FairnessOptions& options) {
  constexpr double kGentlest = 0.1;
  options.reaction_time = section.nonNegative("reaction_time");
  options.aggressiveness = section.within("aggressiveness", kGentlest, 1.0);
  options.avoidable_for = section.nonNegative("avoidable_for");
}

void readOptions(Section& section, AdaptiveOptions& options) {
  options.period = section.positive("period");
  options.commit_time = section.nonNegative("commit_time");
  options.ego_samples = section.count("ego_samples", 1);
  options.min_gain = section.nonNegative("min_gain");
  options.ways = section.count("ways", 1);
  options.min_hope = section.share("min_hope");
  options.evade_time = section.positive("evade_time");
  options.lost_after = section.positive("lost_after");
  options.max_ego_speed = section.positive("max_ego_speed");
  options.rounds = section.count("rounds", 0);
  options.perturbations = section.count("perturbations", 0);
  section.read("drive_on", options.drive_on);
  section.read("fairness", options.fairness);
}

}  // namespace forge
