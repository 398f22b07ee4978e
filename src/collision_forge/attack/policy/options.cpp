#include "collision_forge/attack/policy/options.h"

#include "collision_forge/base/config/section.h"

namespace forge {

static void readOptions(Section& section, FairnessOptions& options) {
  constexpr double kGentlest = 0.1;
  options.reaction_time = section.nonNegative("reaction_time");
  options.aggressiveness = section.within("aggressiveness", kGentlest, 1.0);
  options.avoidable_for = section.nonNegative("avoidable_for");
  std::vector<std::pair<std::string, std::optional<DriverModel>>> drivers = {{"any", {}}};
  for (const DriverModel model : kDriverModels) drivers.emplace_back(toString(model), model);
  options.avoidable_by = section.choice("avoidable_by", drivers);
}

void readOptions(Section& section, AdaptiveOptions& options) {
  options.period = section.positive("period");
  options.commit_time = section.nonNegative("commit_time");
  options.ego_samples = section.count("ego_samples", 1);
  options.evade_time = section.positive("evade_time");
  options.lost_after = section.positive("lost_after");
  options.max_ego_speed = section.positive("max_ego_speed");
  section.read("fairness", options.fairness);
}

}  // namespace forge
