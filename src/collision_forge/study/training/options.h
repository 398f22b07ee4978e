#pragma once

#include "collision_forge/attack/network/options.h"
#include "collision_forge/study/evaluation/options.h"

namespace forge {

/// config/study/training.yaml, section training, where each number's unit stands.
struct TrainingOptions {
  int epochs = 0;
  int batch = 0;
  int times = 0;
  double learning_rate = 0.0;
  double weight_decay = 0.01;
  double dropout = 0.0;
  /// Share of the moments that are learnt from without other agents and lanes
  double context_dropout = 0.4;
  double max_gradient = 5.0;    ///< norm
  double heading_weight = 5.0;  ///< of the losses over that of the ego's place
  double offset_weight = 3.0;
  double selection_weight = 0.3;
  double clip_weight = 2.0;  ///< of the impact of a clip over another instant
  /// Of moments whose other agents lose their history, as those of clips do
  double hidden_history_share = 0.3;
  /// Of moments that are learnt from in a mirror, left and right exchanged; left turns of clips
  /// never
  double mirrored_share = 0.5;
  double validation_share = 0.0;
  double max_tta = 0.0;  ///< of PredictionOptions
  double min_vehicle_speed = 0.0;
  double vehicle_stride = 1.0;  ///< s between the moments of a vehicle
  /// m at 1 s: deviation of where a candidate's attack is thought to end
  double noise_along = 0.3;
  double noise_along_exponent = 1.4;  ///< of the TTA
  double noise_across = 0.1;          ///< m/s
};

/// config/study/planner_training.yaml, where each number's unit and source stand.
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
  /// Of the moments whose ego is not known from so far back, as when a test begins
  double hidden_history_share = 0.5;
  /// Of the moments whose ego is moved off its way, to learn how to come back: by ...
  double moved_share = 0.5;
  double lateral_noise = 0.5;   ///< m, deviation
  double heading_noise = 0.05;  ///< rad, deviation
  double return_time = 1.5;     ///< s in which that fades to 1/e
  double min_future = 1.0;      ///< s; moments with less of it are not learnt from
};

/// What a network is trained by: config/study/training.yaml, a member a section, and what its
/// samples are made with.
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
