#include "collision_forge/generators/options.h"

#include "collision_forge/config/section.h"

namespace forge {

static void readOptions(Section& section, TrafficOptions& options, int history_frames) {
  options.history_frames = history_frames;
  options.future_frames = section.count("future_frames", 1);
  options.max_agents = section.count("max_agents", 2);
  options.min_motion = section.nonNegative("min_motion");
  options.min_step = section.nonNegative("min_step");
}

static void readOptions(Section& section, SocialGanOptions& options) {
  options.epochs = section.count("epochs", 1);
  options.batch = section.count("batch", 1);
  options.learning_rate = section.positive("learning_rate");
  options.max_gradient = section.positive("max_gradient");
  options.embedding = section.count("embedding", 1);
  options.encoder = section.count("encoder", 1);
  options.decoder = section.count("decoder", 1);
  options.pooled = section.count("pooled", 1);
  options.pooling_layer = section.count("pooling_layer", 1);
  options.context_layer = section.count("context_layer", 1);
  options.noise = section.count("noise", 1);
  options.discriminator = section.count("discriminator", 1);
  options.discriminator_steps = section.count("discriminator_steps", 1);
  options.variety = section.count("variety", 1);
  options.step_scale = section.positive("step_scale");
  options.position_scale = section.positive("position_scale");
}

void readOptions(Section& file, GeneratorOptions& options, int history_frames) {
  file.read("traffic", options.traffic, history_frames);
  Section training = file.section("training");
  options.validation_share = training.share("validation_share");
  training.finish();
  file.read("c_sgan", options.c_sgan);
}

}  // namespace forge
