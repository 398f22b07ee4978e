#include "collision_forge/planner_test/planners/options.h"

#include <algorithm>
#include <limits>
#include <set>
#include <string>

#include "collision_forge/base/config/section.h"

namespace forge {
namespace {

constexpr double kMaxOffset = 10.0;  // m
constexpr double kMaxSpeedShare = 2.0;
constexpr double kMaxParameter = std::numeric_limits<double>::max();
constexpr double kMaxSteering = 1.5;  // rad; below 90 degrees

IdmParameters readIdmLaw(Section& section) {
  IdmParameters law;
  law.desired_speed = section.positive("desired_speed");
  law.time_headway = section.nonNegative("time_headway");
  law.max_acceleration = section.positive("max_acceleration");
  law.braking = section.positive("braking");
  law.min_gap = section.nonNegative("min_gap");
  law.exponent = section.positive("exponent");
  return law;
}

/// Reads the parameters in which STRIVE's two sets differ.
RuleBasedOptions withParameters(RuleBasedOptions options, Section section) {
  options.max_speed = section.positive("max_speed");
  options.max_acceleration = section.positive("max_acceleration");
  options.distance_weight = section.nonNegative("distance_weight");
  options.distance_weight_rate = section.nonNegative("distance_weight_rate");
  section.finish();
  return options;
}

void readRuleBased(Section section, PlannerOptions& planners) {
  RuleBasedOptions options;
  options.interaction_radius = section.nonNegative("interaction_radius");
  options.speed_shares = section.numbers("speed_shares", 0.0, kMaxSpeedShare);
  options.acceleration_shares = section.positives("acceleration_shares");
  options.max_probability = section.share("max_probability");
  options.ego_way = section.choice<EgoWay>(
      "ego_way", {{"first", EgoWay::kFirst}, {"along_route", EgoWay::kAlongRoute}});
  planners.rule_based = withParameters(options, section.section("published"));
  planners.tuned_rule_based = withParameters(options, section.section("tuned"));
  section.finish();
}

}  // namespace

static void readOptions(Section& section, KinematicBicycleOptions& options,
                        const VehicleLimits& limits) {
  options.wheelbase = section.positive("wheelbase");
  options.max_steering = section.within("max_steering", 0.0, kMaxSteering);
  options.max_acceleration = limits.max_forward_acceleration;
  options.max_braking = limits.max_braking;
  options.acceleration_lag = section.nonNegative("acceleration_lag");
  options.steering_lag = section.nonNegative("steering_lag");
}

static void readOptions(Section& section, IdmParameters& options) {
  options.min_gap = section.positive("min_gap");
  options.time_headway = section.nonNegative("time_headway");
  options.max_acceleration = section.positive("max_acceleration");
  options.braking = section.positive("braking");
  options.exponent = section.positive("exponent");
}

static void readOptions(Section& section, PdmScoringOptions& options) {
  options.progress_weight = section.nonNegative("progress_weight");
  options.ttc_weight = section.nonNegative("ttc_weight");
  options.comfort_weight = section.positive("comfort_weight");
}

static void readOptions(Section& section, PdmOptions& options) {
  options.speed_limit = section.positive("speed_limit");
  options.lateral_offsets = section.numbers("lateral_offsets", -kMaxOffset, kMaxOffset);
  options.speed_shares = section.positives("speed_shares");
  section.read("scoring", options.scoring);
  const PdmComfortOptions& comfort = options.scoring.comfort;
  options.proposal_steps =
      section.count("proposal_steps", std::max(comfort.jerk_window, comfort.yaw_window));
  options.output_steps = section.count("output_steps", options.proposal_steps);
  section.read("idm", options.idm);
}

static void readOptions(Section& section, PlanningOptions& options) {
  options.history = section.nonNegative("history");
  options.interval = section.atLeast("interval", kMinTimeStep);
}

static void readOptions(Section& section, IdmOptions& options) {
  options.law = readIdmLaw(section);
  options.lead.radius = section.positive("radius");
  options.lead.margin = section.nonNegative("margin");
  options.horizon = section.atLeast("horizon", options.step);
}

static void readOptions(Section& section, PublishedIdmOptions& options) {
  options.law = readIdmLaw(section);
}

static void readOptions(Section& section, ExternalOptions& options) {
  options.interval = section.atLeast("interval", kMinTimeStep);
  options.timeout = section.positive("timeout");
  options.start_timeout = section.positive("start_timeout");
  Section parameters = section.section("parameters");
  for (const std::string& name : std::set<std::string>(parameters.unread())) {
    options.parameters[name] = parameters.within(name, -kMaxParameter, kMaxParameter);
  }
}

static void readOptions(Section& section, TorchscriptOptions& options) {
  options.file = section.path("file");
  options.device =
      section.choice<std::string>("device", {{"auto", "auto"}, {"cpu", "cpu"}, {"cuda", "cuda"}});
  options.interval = section.atLeast("interval", kMinTimeStep);
  options.timeout = section.positive("timeout");
  options.start_timeout = section.positive("start_timeout");
}

void readOptions(Section& file, PlannerOptions& options, const VehicleLimits& limits) {
  file.read("planning", options.planning);
  Section idm = file.section("idm");
  idm.read("standard", options.idm);
  idm.read("published", options.published_idm);
  idm.finish();
  file.read("external", options.external);
  file.read("car", options.car, limits);
  file.read("pdm", options.pdm);
  options.pdm.step = options.lqr.step;
  readRuleBased(file.section("rule_based"), options);
  file.read("torchscript", options.torchscript);
}

}  // namespace forge
