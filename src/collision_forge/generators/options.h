#pragma once

#include <string>

namespace forge {

class Section;

/// config/generators.yaml, section traffic, where each number's unit stands.
struct TrafficOptions {
  int history_frames = 0;  ///< of PredictionOptions; the last one is now
  int future_frames = 0;
  int max_agents = 0;
  double min_motion = 0.0;
  double min_step = 0.0;
};

/// config/generators.yaml, section c_sgan, where each number's unit and source stand.
struct SocialGanOptions {
  int epochs = 0;
  int batch = 0;
  double learning_rate = 0.0;
  double max_gradient = 0.0;
  int embedding = 0;
  int encoder = 0;
  int decoder = 0;
  int pooled = 0;
  int pooling_layer = 0;
  int context_layer = 0;
  int noise = 0;
  int discriminator = 0;
  int discriminator_steps = 0;
  int variety = 0;
  double step_scale = 0.0;
  double position_scale = 0.0;
};

/// config/generators.yaml, a member a section. Kept in the weights.
struct GeneratorOptions {
  TrafficOptions traffic;
  double validation_share = 0.0;
  SocialGanOptions c_sgan;
};

/// Reads generators.yaml. `history_frames` are those of PredictionOptions.
void readOptions(Section& file, GeneratorOptions& options, int history_frames);

}  // namespace forge
