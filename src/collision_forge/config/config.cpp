#include "collision_forge/config/config.h"

#include "collision_forge/config/attack_config.h"
#include "collision_forge/config/config_section.h"
#include "collision_forge/config/planner_config.h"
#include "collision_forge/config/training_config.h"
#include "collision_forge/data/speed_model_file.h"
#include "collision_forge/data/speed_profiles_file.h"

#include <filesystem>
#include <limits>
#include <utility>

namespace forge {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kMaxHeading = 3.1416;  // rad; pi as the files round it

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

EvaluationOptions loadEvaluation(const std::string& directory, NominalOptions& nominal) {
  Section file = openConfigFile(directory, "evaluation.yaml");
  Section section = file.section("evaluation");
  EvaluationOptions options;
  const BoxSize box{section.positive("box_length"), section.positive("box_width")};
  options.collide = readCollide(section.section("collide"));
  options.published = readPublished(section.section("published"));
  nominal = readNominal(section.section("nominal"));
  options.published_search = readPublishedSearch(section.section("published_search"));
  options.statistics = readStatistics(section.section("statistics"));
  options.collide.box = box;
  options.published.box = box;
  section.finish();
  file.finish();
  return options;
}

/// Attacks keep `time_margin` to the ends of every time tolerance.
DatasetOptions loadDataset(const std::string& directory, double time_margin) {
  constexpr double kShareRounding = 1e-9;  // 1 - 0.8 is less than 0.2
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
  options.time_tolerance = section.within("time_tolerance", time_margin, kInfinity);
  options.max_off_road_share = section.within("max_off_road_share", 0.0, 1.0);
  options.balance.min_type_share =
      section.within("min_type_share", 0.0, 1.0 / static_cast<double>(std::size(kCollisionTypes)));
  options.balance.max_tta_ratio = section.within("max_tta_ratio", 1.0, kInfinity);
  options.split.train_share = section.within("train_share", 0.0, 1.0);
  options.split.val_share =
      section.within("val_share", 0.0, 1.0 - options.split.train_share + kShareRounding);
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
  loadAttack(directory, config);
  Section network = openConfigFile(directory, "network.yaml");
  const std::string networks = network.text("pattern_network");
  if (!networks.empty()) config.pattern_network = std::filesystem::path(directory) / networks;
  network.finish();
  Section methods = openConfigFile(directory, "methods.yaml");
  for (const std::string& library : methods.texts("libraries")) {
    config.method_libraries.push_back(std::filesystem::path(directory) / library);
  }
  methods.finish();
  loadTraining(directory, config);
  config.ego_vehicle = loadEgoVehicle(directory);
  config.encoding = loadEncoding(directory);
  config.conversion = loadConversion(directory);
  config.drawing = loadDrawing(directory);
  config.requests = loadRequests(directory);
  config.evaluation = loadEvaluation(directory, config.attack.nominal);
  config.dataset = loadDataset(directory, config.attack.search.time_margin);
  config.planners = loadPlanners(directory, config.attack.verification.limits);
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
