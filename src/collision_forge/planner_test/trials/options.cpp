#include "collision_forge/planner_test/trials/options.h"

#include <cmath>
#include <string>

#include "collision_forge/base/config/section.h"
#include "collision_forge/base/scene/contact_conditions.h"
#include "collision_forge/base/scene/number_words.h"

namespace forge {

static void readOptions(Section& section, RolloutOptions& options) {
  options.step = section.atLeast("step", kMinTimeStep);
}

static void readOptions(Section& section, AvoidabilityOptions& options,
                        const VehicleLimits& limits) {
  options.interval = section.atLeast("interval", kMinTimeStep);
  options.accelerations =
      section.numbers("accelerations", -limits.max_braking, limits.max_forward_acceleration);
  options.draws = section.count("draws", 0);
  options.tries = section.count("tries", 1);
}

static void readOptions(Section& section, UntilHitOptions& options) {
  options.tries = section.count("tries", 1);
  options.min_impact_speed = section.nonNegative("min_impact_speed");
}

static void readOptions(Section& section, SweepOptions& options) {
  Section tolerances = section.section("tolerances");
  for (const char* name : {"impact_speed", "overlap"}) {
    options.tolerances[name] = tolerances.positive(name);
  }
  for (const RangeControl& control : kRangeControls) {
    options.tolerances[control.name] = tolerances.positive(control.name);
  }
  tolerances.finish();
}

/// Checks that `interval` is a multiple of the rollout's step.
static void checkIntervals(const Section& file, const TrialOptions& options) {
  const double step = options.rollout.step;
  const auto check = [&](const char* key, double interval) {
    const double steps = interval / step;
    if (std::round(steps) >= 1.0 && std::abs(steps - std::round(steps)) < 1e-6) return;
    file.refuse(key, numberText(interval) +
                         " s, the time between two calls of a planner, is not a " +
                         "multiple of rollout.step, which is " + numberText(step) + " s");
  };
  check("planning.interval", options.planning.interval);
  check("rollout.step", options.published_idm.step);
  check("rollout.step", options.rule_based.step);
  check("external.interval", options.external.interval);
  check("torchscript.interval", options.torchscript.interval);
}

void readOptions(Section& file, TrialOptions& options, const VehicleLimits& limits) {
  readOptions(file, static_cast<PlannerOptions&>(options), limits);
  options.traffic = options.idm;
  options.traffic_model = options.torchscript;
  options.traffic_model.file.clear();
  options.traffic_model.contract = &kTrafficContract;
  file.read("rollout", options.rollout);
  file.read("avoidability", options.avoidability, limits);
  file.read("until_hit", options.until_hit);
  file.read("sweep", options.sweep);
  options.avoidability.step = options.rollout.step;
  checkIntervals(file, options);
}

}  // namespace forge
