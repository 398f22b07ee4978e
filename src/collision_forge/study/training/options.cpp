#include "collision_forge/study/training/options.h"

#include "collision_forge/base/config/section.h"

namespace forge {

static void readOptions(Section& section, TrainingOptions& options, double max_tta) {
  constexpr double kMaxDropout = 0.9;
  options.epochs = section.count("epochs", 1);
  options.batch = section.count("batch", 1);
  options.times = section.count("times", 1);
  options.learning_rate = section.positive("learning_rate");
  options.dropout = section.within("dropout", 0.0, kMaxDropout);
  options.validation_share = section.share("validation_share");
  options.max_tta = max_tta;
  options.min_vehicle_speed = section.nonNegative("min_vehicle_speed");
}

void readOptions(Section& file, LearningOptions& options) {
  const PredictionOptions& prediction = options.attack.prediction;
  file.read("features", options.pattern_features, prediction.history_frames);
  file.read("network", options.pattern_layers);
  file.read("training", options.training, prediction.max_tta);
}

}  // namespace forge
