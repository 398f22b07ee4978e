#include "collision_forge/planner_test/trials/options.h"

#include <cmath>
#include <limits>
#include <string>

#include "collision_forge/base/config/section.h"
#include "collision_forge/base/scene/number_words.h"

namespace forge {

static void readOptions(Section& section, FaultOptions& options) {
  options.standstill_speed = section.nonNegative("standstill_speed");
  options.front_tolerance = section.nonNegative("front_tolerance");
  options.off_road_share = section.share("off_road_share");
  options.lane_radius = section.nonNegative("lane_radius");
}

static void readOptions(Section& section, RolloutOptions& options) {
  options.step = section.atLeast("step", kMinTimeStep);
  section.read("fault", options.fault);
}

static void readOptions(Section& section, AvoidabilityOptions& options,
                        const VehicleLimits& limits) {
  constexpr double kWidest = 20.0;  // m; no road is wider to either side
  options.interval = section.atLeast("interval", kMinTimeStep);
  options.accelerations =
      section.numbers("accelerations", -limits.max_braking, limits.max_forward_acceleration);
  options.offsets = section.numbers("offsets", -kWidest, kWidest);
  options.durations = section.numbers("durations", 0.0, std::numeric_limits<double>::infinity());
  options.return_time = section.positive("return_time");
  options.min_return_distance = section.positive("min_return_distance");
  options.margin = section.nonNegative("margin");
  options.draws = section.count("draws", 0);
  options.seed = static_cast<std::uint64_t>(section.count("seed", 0));
  options.tries = section.count("tries", 1);
}

static void readOptions(Section& section, NuplanScoreOptions& options) {
  options.min_progress_share = section.share("min_progress_share");
  options.least_progress = section.positive("least_progress");
  options.ttc_horizon = section.positive("ttc_horizon");
  options.direction_window = section.positive("direction_window");
  options.max_overspeed = section.positive("max_overspeed");
  options.acceleration_window = section.count("acceleration_window", 4);
  options.rate_window = section.count("rate_window", 4);
  options.progress_weight = section.positive("progress_weight");
  options.ttc_weight = section.nonNegative("ttc_weight");
  options.speed_limit_weight = section.nonNegative("speed_limit_weight");
  options.comfort_weight = section.nonNegative("comfort_weight");
}

static void readOptions(Section& section, UntilHitOptions& options) {
  options.tries = section.count("tries", 1);
  options.min_impact_speed = section.nonNegative("min_impact_speed");
}

/// Planners are called between steps of a rollout.
static void checkIntervals(const Section& file, const TrialOptions& options) {
  const double step = options.rollout.step;
  const auto check = [&](const char* key, double interval) {
    const double steps = interval / step;
    if (std::round(steps) >= 1.0 && std::abs(steps - std::round(steps)) < 1e-6) return;
    file.refuse(key, "is no multiple of rollout.step, which is " + numberText(step) + " s");
  };
  check("planning.interval", options.planning.interval);
  check("idm.published.step", options.published_idm.step);
  check("rule_based.step", options.rule_based.step);
  check("external.interval", options.external.interval);
  check("torchscript.interval", options.torchscript.interval);
}

void readOptions(Section& file, TrialOptions& options, const VehicleLimits& limits) {
  readOptions(file, static_cast<PlannerOptions&>(options), limits);
  options.traffic = options.idm;
  file.read("rollout", options.rollout);
  file.read("nuplan_score", options.nuplan_score);
  file.read("avoidability", options.avoidability, limits);
  file.read("until_hit", options.until_hit);
  options.rollout.hard_braking = options.pdm.scoring.comfort.max_braking;
  options.rollout.fault.behind_angle = options.pdm.scoring.behind_angle;
  options.avoidability.step = options.rollout.step;
  checkIntervals(file, options);
}

}  // namespace forge
