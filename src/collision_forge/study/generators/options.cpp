#include "collision_forge/study/generators/options.h"

#include <algorithm>

#include "collision_forge/base/config/section.h"

namespace forge {

// Weight files of earlier versions also contain training options that no longer are keys. They are
// ignored, because a trained model does not depend on them.

static void readOptions(Section& section, TrafficLaneOptions& options) {
  options.reach = section.positive("reach");
  options.max_lanes = section.count("max_lanes", 1, kMaxModelCount);
  options.points = section.count("points", 2, kMaxModelCount);
  options.spacing = section.positive("spacing");
}

static void readOptions(Section& section, TrafficOptions& options, int history_frames) {
  options.history_frames = history_frames;
  options.future_frames = section.count("future_frames", 1, kMaxModelCount);
  options.max_agents = section.count("max_agents", 2, kMaxModelCount);
  options.min_motion = section.nonNegative("min_motion");
  options.min_step = section.nonNegative("min_step");
}

static void readOptions(Section& section, SocialGanOptions& options) {
  section.ignore({"max_gradient", "discriminator_steps", "variety"});
  options.epochs = section.count("epochs", 1);
  options.batch = section.count("batch", 1);
  options.learning_rate = section.positive("learning_rate");
  options.embedding = section.count("embedding", 1, kMaxModelWidth);
  options.encoder = section.count("encoder", 1, kMaxModelWidth);
  options.decoder = section.count("decoder", 1, kMaxModelWidth);
  options.pooled = section.count("pooled", 1, kMaxModelWidth);
  options.pooling_layer = section.count("pooling_layer", 1, kMaxModelWidth);
  options.context_layer = section.count("context_layer", 1, kMaxModelWidth);
  options.noise = section.count("noise", 1, kMaxModelWidth);
  if (options.noise >= options.decoder) section.refuse("noise", "is not less than decoder");
  options.discriminator = section.count("discriminator", 1, kMaxModelWidth);
  options.step_scale = section.positive("step_scale");
  options.position_scale = section.positive("position_scale");
}

static void readOptions(Section& section, MidOptions& options) {
  section.ignore({"attacker_weight", "encoder_dropout", "dropout"});
  options.epochs = section.count("epochs", 1);
  options.batch = section.count("batch", 1);
  options.learning_rate = section.positive("learning_rate");
  options.encoder = section.count("encoder", 1, kMaxModelWidth);
  options.width = section.count("width", 4, kMaxModelWidth);
  options.layers = section.count("layers", 1, kMaxModelCount);
  options.heads = section.count("heads", 1, kMaxModelCount);
  if (options.width % 4 != 0 || options.width % options.heads != 0) {
    section.refuse("width", "is not a multiple of 4 and of heads");
  }
  options.feed_forward = section.count("feed_forward", 1, kMaxModelWidth);
  options.diffusion_steps = section.count("diffusion_steps", 1, kMaxModelSteps);
  constexpr double kLeastBeta = 1e-6;  // above 0, because steps divide by it
  constexpr double kMostBeta = 0.999;
  options.beta_first = section.within("beta_first", kLeastBeta, kMostBeta);
  options.beta_last = section.within("beta_last", options.beta_first, kMostBeta);
  options.sampling_steps = section.count("sampling_steps", 1, kMaxModelSteps);
  if (options.diffusion_steps % options.sampling_steps != 0) {
    section.refuse("sampling_steps", "does not divide diffusion_steps");
  }
  options.neighbour_reach = section.positive("neighbour_reach");
  options.position_scale = section.positive("position_scale");
  options.velocity_scale = section.positive("velocity_scale");
  options.acceleration_scale = section.positive("acceleration_scale");
  options.target_scale = section.positive("target_scale");
}

static void readOptions(Section& section, StriveOptions& options) {
  section.ignore({"max_gradient", "noise", "attacker_weight", "divergence_weight",
                  "divergence_steps", "overlap_weight", "off_lanes_weight"});
  options.epochs = section.count("epochs", 1);
  options.batch = section.count("batch", 1);
  options.learning_rate = section.positive("learning_rate");
  options.hidden = section.count("hidden", 1, kMaxModelWidth);
  options.feature = section.count("feature", 1, kMaxModelWidth);
  options.latent = section.count("latent", 1, kMaxModelWidth);
  options.lane_hidden = section.count("lane_hidden", 1, kMaxModelWidth);
  options.lanes_of_agent = section.count("lanes_of_agent", 1, kMaxModelCount);
  options.map_ahead = section.nonNegative("map_ahead");
  options.lane_reach = section.positive("lane_reach");
  options.length = section.positive("length");
  options.width = section.positive("width");
  options.position_scale = section.positive("position_scale");
  options.speed_mean = section.nonNegative("speed_mean");
  options.speed_scale = section.positive("speed_scale");
  options.turn_scale = section.positive("turn_scale");
  options.acceleration_scale = section.positive("acceleration_scale");
  options.turn_change_scale = section.positive("turn_change_scale");
}

static void readOptions(Section& section, PublishedNetworkOptions& options) {
  section.ignore({"decay", "dropout", "place_scale", "positive_weight", "anchors_loss",
                  "anchor_offset_loss", "target_points_loss", "regression_loss", "ego_yaw_loss",
                  "attacker_offset_loss", "attacker_yaw_loss", "selection_loss"});
  options.epochs = section.count("epochs", 1);
  options.batch = section.count("batch", 1);
  options.learning_rate = section.positive("learning_rate");
  options.decay_from = section.count("decay_from", 0);
  options.decay_every = section.count("decay_every", 1);
  options.width = section.count("width", 1, kMaxModelWidth);
  options.condition = section.count("condition", 1, kMaxModelWidth);
  options.selector = section.count("selector", 1, kMaxModelWidth);
  options.anchor_1 = section.count("anchor_1", 1, kMaxModelWidth);
  options.anchor_2 = section.count("anchor_2", 1, kMaxModelWidth);
  options.anchor_3 = section.count("anchor_3", 1, kMaxModelWidth);
  options.anchor_scale = section.positive("anchor_scale");
  options.positive_radius = section.positive("positive_radius");
}

std::vector<std::string> trafficModelNames() {
  return {"c_sgan", "c_mid", "c_strive", "published_network"};
}

bool isPublishedNetwork(const std::string& model) { return model == "published_network"; }

std::string configFileOf(const std::string& model) {
  return isPublishedNetwork(model) ? "study/network_published.yaml" : "study/generators.yaml";
}

std::vector<std::string> sectionsOf(const std::string& model) {
  if (isPublishedNetwork(model)) return {"traffic", "lanes", "network"};
  if (model == "c_strive") return {"traffic", "lanes", "c_strive"};
  return {"traffic", model};
}

std::vector<std::string> sectionsOfGenerators() {
  return {"traffic", "lanes", "c_sgan", "c_mid", "c_strive"};
}

void readOptions(Section& file, GeneratorOptions& options, const std::vector<std::string>& sections,
                 int history_frames) {
  const auto has = [&](const char* name) {
    return std::find(sections.begin(), sections.end(), name) != sections.end();
  };
  file.read("traffic", options.traffic, history_frames);
  file.ignore({"training", "strive_optimised"});
  if (has("lanes")) file.read("lanes", options.traffic.lanes);
  if (has("c_sgan")) file.read("c_sgan", options.c_sgan);
  if (has("c_mid")) file.read("c_mid", options.c_mid);
  if (has("c_strive")) file.read("c_strive", options.c_strive);
  if (has("network")) file.read("network", options.published_network);
}

}  // namespace forge
