#include "collision_forge/config/training_config.h"

#include <stdexcept>

#include "collision_forge/config/config_section.h"

namespace forge {
namespace {

EgoHead readHead(Section& section) {
  const std::string head = section.text("head");
  try {
    return egoHeadFromString(head);
  } catch (const std::invalid_argument& error) {
    section.refuse("head", error.what());
  }
}

PatternFeatureOptions readPatternFeatures(Section section) {
  PatternFeatureOptions options;
  options.head = readHead(section);
  options.history_frames = section.count("history_frames", 1);
  options.agent_frames = section.count("agent_frames", 1, options.history_frames);
  options.max_agents = section.count("max_agents", 1);
  options.encoding.lane_radius = section.positive("lane_radius");
  options.encoding.max_lanes = section.count("max_lanes", 1);
  options.encoding.lane_points = section.count("lane_points", 2);
  options.encoding.lane_point_spacing = section.positive("lane_point_spacing");
  options.max_ways = section.count("max_ways", 1);
  options.way_anchors = section.count("way_anchors", 3);
  options.spacing_floor = section.positive("spacing_floor");
  options.spacing_rate = section.positive("spacing_rate");
  options.spacing_exponent = section.positive("spacing_exponent");
  options.target_lanes = section.count("target_lanes", 1);
  options.target_points = section.count("target_points", 2);
  options.target_spacing = section.positive("target_spacing");
  section.finish();
  return options;
}

PatternNetworkOptions readPatternNetwork(Section section) {
  PatternNetworkOptions options;
  options.hidden = section.count("hidden", 1);
  options.scene = section.count("scene", 1);
  options.anchor = section.count("anchor", 1);
  section.finish();
  return options;
}

TrainingOptions readTraining(Section section) {
  constexpr double kMaxDropout = 0.9;
  TrainingOptions options;
  options.epochs = section.count("epochs", 1);
  options.batch = section.count("batch", 1);
  options.times = section.count("times", 1);
  options.learning_rate = section.positive("learning_rate");
  options.weight_decay = section.nonNegative("weight_decay");
  options.dropout = section.within("dropout", 0.0, kMaxDropout);
  options.context_dropout = section.within("context_dropout", 0.0, 1.0);
  options.max_gradient = section.positive("max_gradient");
  options.heading_weight = section.nonNegative("heading_weight");
  options.offset_weight = section.nonNegative("offset_weight");
  options.selection_weight = section.nonNegative("selection_weight");
  options.clip_weight = section.positive("clip_weight");
  options.hidden_history_share = section.within("hidden_history_share", 0.0, 1.0);
  options.mirrored_share = section.within("mirrored_share", 0.0, 1.0);
  options.validation_share = section.within("validation_share", 0.0, 1.0);
  options.max_tta = section.positive("max_tta");
  options.min_vehicle_speed = section.nonNegative("min_vehicle_speed");
  options.vehicle_stride = section.positive("vehicle_stride");
  options.noise_along = section.nonNegative("noise_along");
  options.noise_along_exponent = section.positive("noise_along_exponent");
  options.noise_across = section.nonNegative("noise_across");
  section.finish();
  return options;
}

}  // namespace

void loadTraining(const std::string& directory, Config& config) {
  Section file = openConfigFile(directory, "training.yaml");
  config.pattern_features = readPatternFeatures(file.section("features"));
  config.pattern_layers = readPatternNetwork(file.section("network"));
  config.training = readTraining(file.section("training"));
  file.finish();
}

}  // namespace forge
