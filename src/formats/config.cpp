#include "formats/config.h"

#include "formats/config_section.h"
#include "formats/planner_config.h"
#include "formats/speed_model_file.h"
#include "formats/speed_profiles_file.h"
#include "formats/training_config.h"

#include <filesystem>
#include <limits>
#include <utility>

namespace forge {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kMaxHeading = 3.1416;   // rad; pi as the files round it
constexpr double kMaxLaneHeading = 1.5;  // rad; an ego that crosses a lane does not follow it

VehicleLimits loadVehicleLimits(const std::string& directory) {
  Section file = openConfigFile(directory, "vehicle_limits.yaml");
  Section section = file.section("vehicle_limits");
  VehicleLimits limits;
  limits.max_forward_acceleration = section.positive("max_forward_acceleration");
  limits.max_braking = section.positive("max_braking");
  limits.max_total_acceleration = section.positive("max_total_acceleration");
  limits.max_curvature = section.positive("max_curvature");
  limits.max_speed = section.positive("max_speed");
  limits.curvature_min_speed = section.nonNegative("curvature_min_speed");
  limits.heading_slack = section.nonNegative("heading_slack");
  limits.heading_per_metre = section.nonNegative("heading_per_metre");
  section.finish();
  file.finish();
  return limits;
}

EgoVehicle loadEgoVehicle(const std::string& directory) {
  Section file = openConfigFile(directory, "ego_vehicle.yaml");
  Section section = file.section("ego_vehicle");
  EgoVehicle vehicle;
  vehicle.size = {section.positive("length"), section.positive("width")};
  const double half_length = 0.5 * vehicle.size.length;
  vehicle.center_offset = section.within("center_offset", -half_length, half_length);
  section.finish();
  file.finish();
  return vehicle;
}

void loadCollisionTypes(const std::string& directory, AttackOptions& options) {
  Section file = openConfigFile(directory, "collision_types.yaml");
  Section types = file.section("collision_types");
  options.type_rules = types.typeRules("rules");
  for (const CollisionType type : kCollisionTypes) {
    Section section = types.section(toString(type));
    TypeDefinition& definition = options.collision_types[type];
    definition.min_heading = section.within("min_heading", 0.0, kMaxHeading);
    definition.max_heading = section.within("max_heading", definition.min_heading, kMaxHeading);
    definition.nominal_heading =
        section.within("nominal_heading", definition.min_heading, definition.max_heading);
    definition.min_approach = section.within("min_approach", 0.0, kMaxHeading);
    definition.max_approach = section.within("max_approach", definition.min_approach, kMaxHeading);
    section.finish();
  }
  types.finish();
  file.finish();
}

PredictionOptions loadPrediction(const std::string& directory) {
  Section file = openConfigFile(directory, "prediction.yaml");
  Section section = file.section("prediction");
  PredictionOptions options;
  options.history_frames = section.count("history_frames", 1);
  options.min_history_frames = section.count("min_history_frames", 1, options.history_frames);
  options.motion_frames = section.count("motion_frames", 2);
  options.min_tta = section.positive("min_tta");
  options.max_tta = section.within("max_tta", options.min_tta, kInfinity);
  options.candidate_radius = section.positive("candidate_radius");
  options.step = section.positive("step");
  options.tail = section.positive("tail");
  options.ego_samples = section.count("ego_samples", 2);
  options.lane_max_distance = section.nonNegative("lane_max_distance");
  options.lane_max_heading = section.within("lane_max_heading", 0.0, kMaxHeading);
  options.standstill_speed = section.nonNegative("standstill_speed");
  options.lane_return_distance = section.positive("lane_return_distance");
  options.rear_end_closing_speed = section.positive("rear_end_closing_speed");
  options.min_impact_speed = section.nonNegative("min_impact_speed");
  section.finish();
  file.finish();
  return options;
}

BicycleOptions readBicycle(Section section) {
  BicycleOptions options;
  options.iterations = section.count("iterations", 1);
  options.convergence = section.nonNegative("convergence");
  options.max_miss = section.positive("max_miss");
  options.turn_heading = section.nonNegative("turn_heading");
  options.position_scale = section.positive("position_scale");
  options.heading_scale = section.positive("heading_scale");
  options.speed_scale = section.positive("speed_scale");
  options.acceleration_scale = section.positive("acceleration_scale");
  options.curvature_scale = section.positive("curvature_scale");
  section.finish();
  return options;
}

SteeringOptions readSteering(Section section) {
  SteeringOptions options;
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
  section.finish();
  return options;
}

SearchOptions readSearch(Section section) {
  SearchOptions options;
  options.step = section.positive("step");
  options.tail = section.within("tail", options.step, kInfinity);
  options.depth = section.nonNegative("depth");
  options.limit_margin = section.within("limit_margin", 0.0, 1.0);
  options.heading_margin = section.nonNegative("heading_margin");
  options.time_margin = section.nonNegative("time_margin");
  options.overlap_margin = section.nonNegative("overlap_margin");
  options.max_attackers = section.count("max_attackers", 1);
  options.lane_paths = section.count("lane_paths", 0);
  options.ego_poses = section.count("ego_poses", 1);
  options.draws = section.count("draws", 1);
  options.max_lead = section.nonNegative("max_lead");
  options.kept = section.count("kept", 1);
  options.rounds = section.count("rounds", 0);
  options.perturbations = section.count("perturbations", 0);
  options.bicycle_targets = section.count("bicycle_targets", 0);
  options.bicycle_rounds = section.count("bicycle_rounds", 0);
  options.bicycle_perturbations = section.count("bicycle_perturbations", 0);
  options.good_share = section.within("good_share", 0.0, 1.0);
  options.good_off_road = section.within("good_off_road", 0.0, 1.0);
  options.off_road_weight = section.nonNegative("off_road_weight");
  options.effort_weight = section.nonNegative("effort_weight");
  options.closeness_weight = section.within("closeness_weight", 0.0, 1.0);
  options.confidence_curve = section.risingShares("confidence_curve");
  options.min_confidence = section.within("min_confidence", 0.0, 1.0);
  section.finish();
  return options;
}

VerificationOptions loadVerification(const std::string& directory) {
  Section file = openConfigFile(directory, "verification.yaml");
  Section section = file.section("verification");
  VerificationOptions options;
  options.time_tolerance = section.positive("time_tolerance");
  options.overlap_tolerance = section.positive("overlap_tolerance");
  options.off_road_interval = section.positive("off_road_interval");
  section.finish();
  file.finish();
  return options;
}

FeatureWeights readFeatureWeights(Section section) {
  const char* const features[kSpeedFeatures] = {
      "speed",     "acceleration", "acceleration_before", "acceleration_long_before",
      "turn_rate", "bend_braking", "bend_turn",           "bend_curvature",
      "headway",   "closing"};
  FeatureWeights weights = {};
  for (std::size_t i = 0; i < kSpeedFeatures; ++i) {
    weights[i] = section.nonNegative(features[i]);
  }
  section.finish();
  return weights;
}

SpeedModelFitOptions loadSpeedModelFit(const std::string& directory) {
  Section file = openConfigFile(directory, "speed_model_fit.yaml");
  Section section = file.section("speed_model_fit");
  SpeedModelFitOptions options;
  options.intervals = section.count("intervals", 1);
  options.centers = section.count("centers", 1);
  options.cluster_rounds = section.count("cluster_rounds", 1);
  options.folds = section.count("folds", 2);
  options.gain_ridge = section.positive("gain_ridge");
  options.spread_ridge = section.positive("spread_ridge");
  options.linear_ridge = section.positive("linear_ridge");
  options.spread_floor = section.positive("spread_floor");
  options.profiles = section.count("profiles", 1);
  options.standing_speed = section.nonNegative("standing_speed");
  options.standing_profiles = section.count("standing_profiles", 1);
  options.standing_ridge = section.positive("standing_ridge");
  options.feature_weights = readFeatureWeights(section.section("feature_weights"));
  section.finish();
  file.finish();
  return options;
}

SpeedProfileOptions readSpeedProfiles(Section section) {
  SpeedProfileOptions options;
  options.neighbors = section.count("neighbors", 1);
  options.ridge = section.positive("ridge");
  options.residual_scale = section.nonNegative("residual_scale");
  options.feature_weights = readFeatureWeights(section.section("feature_weights"));
  section.finish();
  return options;
}

EgoPathOptions readEgoPaths(Section section) {
  EgoPathOptions options;
  options.lane_max_distance = section.nonNegative("lane_max_distance");
  options.lane_max_heading = section.within("lane_max_heading", 0.0, kMaxLaneHeading);
  options.max_lanes = section.count("max_lanes", 0);
  options.max_paths_per_lane = section.count("max_paths_per_lane", 1);
  options.near_deviation_cost = section.nonNegative("near_deviation_cost");
  options.far_deviation_cost = section.nonNegative("far_deviation_cost");
  options.bend_braking_cost = section.nonNegative("bend_braking_cost");
  options.turn_cost = section.nonNegative("turn_cost");
  options.free_path_cost = section.nonNegative("free_path_cost");
  options.comfortable_lateral_acceleration = section.positive("comfortable_lateral_acceleration");
  options.turn_rate_fading = section.positive("turn_rate_fading");
  section.finish();
  return options;
}

EgoFutureOptions readEgoFutures(Section section) {
  EgoFutureOptions options;
  options.step = section.positive("step");
  options.paths = readEgoPaths(section.section("paths"));
  options.speed = readSpeedProfiles(section.section("speed"));
  Section lateral = section.section("lateral");
  options.lane_return_time = lateral.positive("lane_return_time");
  options.lane_return_min_distance = lateral.positive("lane_return_min_distance");
  options.kept_offset = lateral.within("kept_offset", 0.0, 1.0);
  options.offset_spread = lateral.nonNegative("offset_spread");
  options.turn_rate_spread = lateral.nonNegative("turn_rate_spread");
  lateral.finish();
  Section no_profiles = section.section("no_profiles");
  options.acceleration_fading = no_profiles.positive("acceleration_fading");
  options.acceleration_spread = no_profiles.nonNegative("acceleration_spread");
  no_profiles.finish();
  section.finish();
  return options;
}

EncodingOptions loadEncoding(const std::string& directory) {
  Section file = openConfigFile(directory, "encoding.yaml");
  Section section = file.section("encoding");
  EncodingOptions options;
  options.lane_radius = section.positive("lane_radius");
  options.max_lanes = section.count("max_lanes", 1);
  options.lane_points = section.count("lane_points", 2);
  options.lane_point_spacing = section.positive("lane_point_spacing");
  section.finish();
  file.finish();
  return options;
}

ConversionOptions loadConversion(const std::string& directory) {
  Section file = openConfigFile(directory, "conversion.yaml");
  Section section = file.section("conversion");
  ConversionOptions options;
  options.map_radius = section.positive("map_radius");
  options.centerline_resolution = section.positive("centerline_resolution");
  section.finish();
  file.finish();
  return options;
}

RequestListOptions loadRequests(const std::string& directory) {
  Section file = openConfigFile(directory, "requests.yaml");
  Section section = file.section("requests");
  RequestListOptions options;
  options.stride = section.positive("stride");
  options.ttas = section.positives("ttas");
  options.min_ego_speed = section.nonNegative("min_ego_speed");
  section.finish();
  file.finish();
  return options;
}

void readDrawingSizes(Section& section, DrawingOptions& options) {
  constexpr int kMinPixels = 64;
  constexpr int kMaxPixels = 8192;
  options.png_width = section.count("png_width", kMinPixels, kMaxPixels);
  options.png_height = section.count("png_height", kMinPixels, kMaxPixels);
  options.png_font_size = section.positive("png_font_size");
  options.chart_width = section.count("chart_width", kMinPixels, kMaxPixels);
  options.chart_height = section.count("chart_height", kMinPixels, kMaxPixels);
  options.plot_size = section.count("plot_size", kMinPixels, kMaxPixels);
  options.gif_width = section.count("gif_width", kMinPixels, kMaxPixels);
  options.gif_height = section.count("gif_height", kMinPixels, kMaxPixels);
  options.gif_font_size = section.positive("gif_font_size");
  options.gif_frames_per_second = section.positive("gif_frames_per_second");
  options.gif_seconds_after_contact = section.nonNegative("gif_seconds_after_contact");
  options.gif_contact_hold = section.nonNegative("gif_contact_hold");
  options.seconds_before_now = section.nonNegative("seconds_before_now");
  options.view_margin = section.nonNegative("view_margin");
  options.min_extent = section.positive("min_extent");
  options.close_up_extent = section.positive("close_up_extent");
  options.scale_bar = section.positive("scale_bar");
  options.ghost_interval = section.positive("ghost_interval");
  options.ghost_opacity = section.within("ghost_opacity", 0.0, 1.0);
}

DrawingOptions loadDrawing(const std::string& directory) {
  Section file = openConfigFile(directory, "drawing.yaml");
  Section section = file.section("drawing");
  DrawingOptions options;
  readDrawingSizes(section, options);
  options.background_color = section.color("background_color");
  options.text_color = section.color("text_color");
  options.muted_text_color = section.color("muted_text_color");
  options.drivable_color = section.color("drivable_color");
  options.walkway_color = section.color("walkway_color");
  options.lane_color = section.color("lane_color");
  options.connector_color = section.color("connector_color");
  options.agent_color = section.color("agent_color");
  options.ego_color = section.color("ego_color");
  options.attacker_color = section.color("attacker_color");
  options.pattern_ego_color = section.color("pattern_ego_color");
  options.pattern_attacker_color = section.color("pattern_attacker_color");
  options.contact_color = section.color("contact_color");
  options.passed_color = section.color("passed_color");
  options.failed_color = section.color("failed_color");
  section.finish();
  file.finish();
  return options;
}

CollideOptions readCollide(Section section) {
  CollideOptions options;
  options.tail = section.positive("tail");
  options.held_out_share = section.within("held_out_share", 0.0, 1.0);
  section.finish();
  return options;
}

PublishedOptions readPublished(Section section) {
  PublishedOptions options;
  options.min_overlap = section.within("min_overlap", 0.0, 1.0);
  options.steps_per_interval = section.count("steps_per_interval", 1);
  options.steps_after = section.count("steps_after", 1);
  options.similar_heading = section.within("similar_heading", 0.0, kMaxHeading);
  section.finish();
  return options;
}

NominalOptions readNominal(Section section) {
  NominalOptions options;
  options.end_distance = section.positive("end_distance");
  options.side_distance = section.positive("side_distance");
  options.lane_change_ahead = section.nonNegative("lane_change_ahead");
  options.lane_change_side = section.nonNegative("lane_change_side");
  options.lane_change_heading = section.within("lane_change_heading", 0.0, kMaxHeading);
  section.finish();
  return options;
}

PublishedSearchOptions readPublishedSearch(Section section) {
  PublishedSearchOptions options;
  options.heading_tolerance = section.within("heading_tolerance", 0.0, kMaxHeading);
  options.latest = section.nonNegative("latest");
  options.overlap_margin = section.nonNegative("overlap_margin");
  options.max_lead = section.nonNegative("max_lead");
  options.max_speed = section.positive("max_speed");
  options.kept = section.count("kept", 1);
  options.futures = section.count("futures", 1);
  section.finish();
  return options;
}

StatisticsOptions readStatistics(Section section) {
  StatisticsOptions options;
  options.resamples = section.count("resamples", 1);
  options.confidence = section.within("confidence", 0.0, 1.0);
  options.seed = static_cast<std::uint64_t>(section.count("seed", 0));
  section.finish();
  return options;
}

EvaluationOptions loadEvaluation(const std::string& directory) {
  Section file = openConfigFile(directory, "evaluation.yaml");
  Section section = file.section("evaluation");
  EvaluationOptions options;
  const BoxSize box{section.positive("box_length"), section.positive("box_width")};
  options.collide = readCollide(section.section("collide"));
  options.published = readPublished(section.section("published"));
  options.nominal = readNominal(section.section("nominal"));
  options.published_search = readPublishedSearch(section.section("published_search"));
  options.statistics = readStatistics(section.section("statistics"));
  options.collide.box = box;
  options.published.box = box;
  section.finish();
  file.finish();
  return options;
}

DatasetOptions loadDataset(const std::string& directory) {
  Section file = openConfigFile(directory, "dataset.yaml");
  Section section = file.section("dataset");
  DatasetOptions options;
  options.begin_stride = section.positive("begin_stride");
  // Now is 3.5 s after the begin, and the shortest TTA is 0.5 s after that; a clip's name has 8
  // frames or more.
  options.min_length = section.within("min_length", 4.0, kInfinity);
  options.max_length = section.within("max_length", options.min_length, kInfinity);
  options.min_ego_speed = section.nonNegative("min_ego_speed");
  Section attempts = section.section("attempts");
  for (const CollisionType type : kCollisionTypes) {
    options.attempts[type] = attempts.count(toString(type), 0);
  }
  attempts.finish();
  options.heading_spread = section.positive("heading_spread");
  options.time_tolerance = section.positive("time_tolerance");
  options.max_off_road_share = section.within("max_off_road_share", 0.0, 1.0);
  options.balance.min_type_share =
      section.within("min_type_share", 0.0, 1.0 / static_cast<double>(std::size(kCollisionTypes)));
  options.balance.max_tta_ratio = section.within("max_tta_ratio", 1.0, kInfinity);
  options.split.train_share = section.within("train_share", 0.0, 1.0);
  options.split.val_share = section.within("val_share", 0.0, 1.0 - options.split.train_share);
  options.sheet_columns = section.count("sheet_columns", 1);
  options.sheet_rows = section.count("sheet_rows", 1);
  section.finish();
  file.finish();
  return options;
}

std::map<std::string, DrivingSide> loadLocations(const std::string& directory) {
  Section file = openConfigFile(directory, "locations.yaml");
  Section section = file.section("locations");
  std::map<std::string, DrivingSide> locations;
  while (!section.unread().empty()) {
    const std::string prefix = *section.unread().begin();
    locations[prefix] = section.drivingSide(prefix);
  }
  file.finish();
  return locations;
}

}  // namespace

Config loadConfig(const std::string& directory) {
  Config config;
  config.attack.vehicle_limits = loadVehicleLimits(directory);
  loadCollisionTypes(directory, config.attack);
  config.attack.prediction = loadPrediction(directory);
  Section search = openConfigFile(directory, "search.yaml");
  config.attack.search = readSearch(search.section("search"));
  config.attack.bicycle = readBicycle(search.section("bicycle"));
  config.attack.steering = readSteering(search.section("steering"));
  search.finish();
  config.attack.verification = loadVerification(directory);
  Section ego_futures = openConfigFile(directory, "ego_futures.yaml");
  config.attack.ego_futures = readEgoFutures(ego_futures.section("ego_futures"));
  const std::string profiles = ego_futures.text("speed_profiles");
  if (!profiles.empty()) config.speed_profiles = std::filesystem::path(directory) / profiles;
  const std::string model = ego_futures.text("speed_model");
  if (!model.empty()) config.speed_model = std::filesystem::path(directory) / model;
  ego_futures.finish();
  config.speed_model_fit = loadSpeedModelFit(directory);
  Section network = openConfigFile(directory, "network.yaml");
  const std::string networks = network.text("pattern_network");
  if (!networks.empty()) config.pattern_network = std::filesystem::path(directory) / networks;
  network.finish();
  loadTraining(directory, config);
  config.ego_vehicle = loadEgoVehicle(directory);
  config.encoding = loadEncoding(directory);
  config.conversion = loadConversion(directory);
  config.drawing = loadDrawing(directory);
  config.requests = loadRequests(directory);
  config.evaluation = loadEvaluation(directory);
  config.dataset = loadDataset(directory);
  config.planners = loadPlanners(directory, config.attack.vehicle_limits);
  config.locations = loadLocations(directory);
  return config;
}

std::shared_ptr<const SpeedForecaster> loadSpeedForecaster(const Config& config) {
  if (!config.speed_profiles.empty()) {
    return std::make_shared<const SpeedProfiles>(
        readSpeedProfiles(config.speed_profiles, config.attack.ego_futures.speed));
  }
  if (config.speed_model.empty()) return nullptr;
  return std::make_shared<const SpeedModel>(readSpeedModel(config.speed_model));
}

DrivingSide drivingSide(const Config& config, const std::string& location) {
  const std::pair<const std::string, DrivingSide>* best = nullptr;
  for (const auto& entry : config.locations) {
    const bool fits = location.compare(0, entry.first.size(), entry.first) == 0;
    if (fits && (!best || entry.first.size() > best->first.size())) best = &entry;
  }
  if (!best) {
    throw ConfigError("locations.yaml: no prefix under locations fits location = " + location);
  }
  return best->second;
}

}  // namespace forge
