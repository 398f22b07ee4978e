#pragma once

namespace forge {

class Section;

/// config/training.yaml, section training, where each number's unit stands.
struct TrainingOptions {
  int epochs = 0;
  int batch = 0;
  int times = 0;
  double learning_rate = 0.0;
  double weight_decay = 0.0;
  double dropout = 0.0;
  double context_dropout = 0.0;
  double max_gradient = 0.0;
  double heading_weight = 0.0;
  double offset_weight = 0.0;
  double selection_weight = 0.0;
  double clip_weight = 0.0;
  double hidden_history_share = 0.0;
  double mirrored_share = 0.0;
  double validation_share = 0.0;
  double max_tta = 0.0;  ///< of PredictionOptions
  double min_vehicle_speed = 0.0;
  double vehicle_stride = 0.0;
  double noise_along = 0.0;
  double noise_along_exponent = 0.0;
  double noise_across = 0.0;
};

/// `max_tta` is that of PredictionOptions.
void readOptions(Section& section, TrainingOptions& options, double max_tta);

}  // namespace forge
