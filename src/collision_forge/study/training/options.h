#pragma once

#include "collision_forge/attack/network/options.h"
#include "collision_forge/study/evaluation/options.h"

namespace forge {

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

/// config/planner_training.yaml, where each number's unit and source stand.
struct PlannerTrainingOptions {
  int epochs = 0;
  int batch = 0;
  int hidden = 0;
  int terms = 0;
  double learning_rate = 0.0;
  double weight_decay = 0.0;
  double max_gradient = 0.0;
  double heading_weight = 0.0;
  double mirrored_share = 0.0;
  double hidden_history_share = 0.0;
  double moved_share = 0.0;
  double lateral_noise = 0.0;
  double heading_noise = 0.0;
  double return_time = 0.0;
  double min_future = 0.0;
};

/// What a network is trained by: config/training.yaml, a member a section, and what its samples are
/// made with.
struct LearningOptions : StudyOptions {
  PatternFeatureOptions pattern_features;
  PatternNetworkOptions pattern_layers;
  TrainingOptions training;
  PlannerTrainingOptions planner_training;
};

void readOptions(Section& section, PlannerTrainingOptions& options);

/// Reads training.yaml, when `attack` is known.
void readOptions(Section& file, LearningOptions& options);

}  // namespace forge
