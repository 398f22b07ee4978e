#include "collision_forge/attack/search/options.h"

#include <utility>

#include "collision_forge/base/config/config_file.h"
#include "collision_forge/base/config/config_folder.h"

namespace forge {

static void readOptions(Section& section, BicycleOptions& options) {
  options.iterations = section.count("iterations", 1);
  options.convergence = section.nonNegative("convergence");
  options.max_miss = section.positive("max_miss");
  options.turn_heading = section.nonNegative("turn_heading");
  options.position_scale = section.positive("position_scale");
  options.heading_scale = section.positive("heading_scale");
  options.speed_scale = section.positive("speed_scale");
  options.acceleration_scale = section.positive("acceleration_scale");
  options.curvature_scale = section.positive("curvature_scale");
}

static void readOptions(Section& section, SteeringOptions& options) {
  options.step = section.positive("step");
  options.first_population = section.count("first_population", 1);
  options.population = section.count("population", 1);
  options.elites = section.count("elites", 1);
  options.rounds = section.count("rounds", 0);
  options.considered = section.count("considered", 1);
  options.patience = section.count("patience", 1);
  options.hopeless = section.positive("hopeless");
  options.acceleration_deviation = section.positive("acceleration_deviation");
  options.curvature_deviation = section.positive("curvature_deviation");
  options.least_acceleration_deviation = section.nonNegative("least_acceleration_deviation");
  options.least_curvature_deviation = section.nonNegative("least_curvature_deviation");
  options.heading_weight = section.nonNegative("heading_weight");
  options.clearance = section.nonNegative("clearance");
  options.near = section.positive("near");
}

static void readOptions(Section& section, SearchOptions& options) {
  options.step = section.positive("step");
  options.tail = section.atLeast("tail", options.step);
  options.depth = section.nonNegative("depth");
  options.limit_margin = section.share("limit_margin");
  options.heading_margin = section.nonNegative("heading_margin");
  options.time_margin = section.positive("time_margin");
  options.overlap_margin = section.nonNegative("overlap_margin");
  options.max_attackers = section.count("max_attackers", 1);
  options.ego_poses = section.count("ego_poses", 1);
  options.draws = section.count("draws", 1);
  options.homed = section.count("homed", 0);
  options.corrections = section.count("corrections", 0);
  options.max_lead = section.nonNegative("max_lead");
  options.kept = section.count("kept", 1);
  options.rounds = section.count("rounds", 0);
  options.perturbations = section.count("perturbations", 0);
  options.bicycle_targets = section.count("bicycle_targets", 0);
  options.bicycle_rounds = section.count("bicycle_rounds", 0);
  options.bicycle_perturbations = section.count("bicycle_perturbations", 0);
  options.good_share = section.share("good_share");
  options.good_off_road = section.share("good_off_road");
  options.good_steering = section.positive("good_steering");
  options.off_road_weight = section.nonNegative("off_road_weight");
  options.effort_weight = section.nonNegative("effort_weight");
  options.steering_weight = section.nonNegative("steering_weight");
  options.quick_steering = section.positive("quick_steering");
  options.closeness_weight = section.share("closeness_weight");
  options.pattern_weight = section.nonNegative("pattern_weight");
  options.near_pattern = section.positive("near_pattern");
  options.exact_distance = section.positive("exact_distance");
  options.exact_heading = section.positive("exact_heading");
  options.confidence_curve = section.risingShares("confidence_curve");
}

void readOptions(Section& section, RequestListOptions& options) {
  options.stride = section.positive("stride");
  options.ttas = section.positives("ttas");
  options.min_ego_speed = section.nonNegative("min_ego_speed");
}

static DrivingStyle readStyle(Section section) {
  DrivingStyle style;
  style.forward = section.positive("forward");
  style.braking = section.positive("braking");
  style.lateral = section.positive("lateral");
  style.jerk = section.positive("jerk");
  style.cost = section.nonNegative("cost");
  section.finish();
  return style;
}

static void readOptions(Section& section, AnyMotionOptions& options) {
  options.bicycle_targets = section.count("bicycle_targets", 0);
  options.bicycle_rounds = section.count("bicycle_rounds", 0);
}

static void readOptions(Section& section, RouteDriverOptions& options) {
  Section styles = section.section("styles");
  for (const char* name : {"calm", "gentle", "brisk", "hard"}) {
    options.styles.push_back(readStyle(styles.section(name)));
  }
  styles.finish();
  options.variation = section.nonNegative("variation");
  options.variation_periods = section.positives("variation_periods");
  if (options.variation_periods.size() != 2 ||
      options.variation_periods.front() > options.variation_periods.back()) {
    section.refuse("variation_periods", "is not a shortest and a longest period");
  }
  options.limit_share = section.share("limit_share");
  options.settling = section.positive("settling");
  options.return_distance = section.positive("return_distance");
  options.precision = section.positive("precision");
  options.preview = section.positive("preview");
  options.branches = section.count("branches", 1);
  options.ways = section.count("ways", 1);
  options.reach = section.positive("reach");
  options.max_departure = section.positive("max_departure");
  options.max_lean = section.angle("max_lean");
  options.heading_margin = section.nonNegative("heading_margin");
  options.contacts = section.numbers("contacts", -1.0, 1.0);
  options.drafted = section.count("drafted", 1);
  options.departures = section.positives("departures");
  options.leads = section.numbers("leads", 0.0, 2.0);
  options.late_braking = section.numbers("late_braking", 0.0, 20.0);
  options.parking_distance = section.nonNegative("parking_distance");
  options.starts = section.positives("starts");
  options.rounds = section.count("rounds", 0);
  options.perturbations = section.count("perturbations", 0);
  options.departure_weight = section.nonNegative("departure_weight");
  options.off_lane_weight = section.nonNegative("off_lane_weight");
  options.off_road_weight = section.nonNegative("off_road_weight");
  options.wrong_way_weight = section.nonNegative("wrong_way_weight");
}

/// The classes that may attack, with the vans and pick-ups that nuScenes takes for trucks.
static std::vector<AddedKind> readKinds(Section section) {
  std::vector<AddedKind> kinds;
  for (const auto& [name, agent_class] :
       {std::pair{"car", AgentClass::kCar},
        {"van", AgentClass::kTruck},
        {"truck", AgentClass::kTruck},
        {"bus", AgentClass::kBus},
        {"construction_vehicle", AgentClass::kConstructionVehicle},
        {"emergency_vehicle", AgentClass::kEmergencyVehicle},
        {"motorcycle", AgentClass::kMotorcycle}}) {
    Section row = section.section(name);
    kinds.push_back({agent_class, row.share("share"), row.positive("length"),
                     row.nonNegative("length_deviation"), row.positive("width")});
    row.finish();
  }
  section.finish();
  return kinds;
}

static void readOptions(Section& section, AddedVehicleOptions& options) {
  options.kinds = readKinds(section.section("kinds"));
  options.candidates = section.count("candidates", 1);
  options.predicted_candidates = section.count("predicted_candidates", 1);
  options.preference = section.share("preference");
  options.sensing_range = section.positive("sensing_range");
  options.least_past = section.positive("least_past");
  options.clearance = section.nonNegative("clearance");
  options.min_on_lane = section.share("min_on_lane");
  options.max_off_road = section.share("max_off_road");
  options.branches = section.count("branches", 1);
  options.way_ahead = section.positive("way_ahead");
  options.lateral = section.positive("lateral");
  options.braking = section.positive("braking");
  options.contacts = section.numbers("contacts", -1.0, 1.0);
  options.speeds = section.positives("speeds");
  options.closings = section.numbers("closings", -5.0, 5.0);
  options.least_gap = section.positive("least_gap");
  options.train_distance = section.positive("train_distance");
  options.starts = section.positives("starts");
  options.parked = section.positives("parked");
  options.riding_gap = section.positive("riding_gap");
  options.riding_cost = section.nonNegative("riding_cost");
  options.aside = section.nonNegative("aside");
  options.wait = section.positive("wait");
  options.least_crossing_speed = section.nonNegative("least_crossing_speed");
}

static void readOptions(Section& file, AttackOptions& options) {
  file.read("routes", options.route);
  file.read("any_motion", options.any_motion);
  file.read("added", options.added);
  file.read("search", options.search);
  file.read("bicycle_family", options.bicycle);
  file.read("steering", options.steering);
}

void readAttackOptions(const ConfigFolder& directory, AttackOptions& options) {
  readConfigFile(directory, "prediction", options.prediction);
  readConfigFile(openConfigFile(directory, "search.yaml"), options);
  readConfigFile(directory, "believability", options.verification.believability);
  Section limits = openConfigFile(directory, "vehicle_limits.yaml");
  Section inner = limits.section("vehicle_limits");
  readVehicleLimits(inner, options.verification);
  inner.finish();
  limits.finish();
  options.verification.motion_frames = options.prediction.motion_frames;
  options.verification.standstill_speed = options.prediction.standstill_speed;
  readConfigFile(directory, "ego_futures", options.ego_futures, options.prediction.step);
}

}  // namespace forge
