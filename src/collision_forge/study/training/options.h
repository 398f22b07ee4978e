#pragma once

#include "collision_forge/attack/network/options.h"
#include "collision_forge/study/evaluation/options.h"

namespace forge {

/// config/study/training.yaml, section training. A sample is a moment of a recording or of a clip.
/// Fields with a default other than 0 are not in the file.
struct TrainingOptions {
  int epochs = 0;  ///< passes over the training data
  int batch = 0;   ///< samples per step
  int times = 0;   ///< prediction times per sample and step, drawn from TrainingSample::times
  double learning_rate = 0.0;     ///< peak value for AdamW; warm-up, then cosine decay
  double weight_decay = 0.01;     ///< weight decay of AdamW
  double dropout = 0.0;           ///< probability 0..1 to drop an activation
  double context_dropout = 0.4;   ///< probability 0..1 to drop all other agents and lanes
  double max_gradient = 5.0;      ///< norm to which larger gradients are clipped
  double heading_weight = 5.0;    ///< weight of TrainingLosses::heading; TrainingLosses::ego has 1
  double offset_weight = 3.0;     ///< weight of TrainingLosses::offset
  double selection_weight = 0.3;  ///< weight of TrainingLosses::selection
  /// Weight of the impact of a clip in the ego's losses; other times have 1.
  double clip_weight = 2.0;
  double hidden_history_share = 0.3;  ///< share 0..1 of the uses of samples without attack in which
                                      ///< the history of other agents is hidden
  double mirrored_share = 0.5;        ///< share 0..1 of the uses of samples with left and right
                                      ///< exchanged; never ltap
  double validation_share = 0.0;      ///< share 0..1 of the scenes for validation, splitByScene()
  double max_tta = 0.0;               ///< s, PredictionOptions::max_tta
  /// m/s, mean over the recording; slower vehicles do not serve as ego.
  double min_vehicle_speed = 0.0;
  double vehicle_stride = 1.0;  ///< s between the samples of a vehicle that serves as ego
  /// Standard deviation of the (normal) noise on the ego pose that candidates are scored with:
  /// noise_along * TTA^noise_along_exponent along the heading, noise_across * TTA across it.
  double noise_along = 0.3;           ///< m at a TTA of 1 s
  double noise_along_exponent = 1.4;  ///< without unit
  double noise_across = 0.1;          ///< m/s
};

/// The configuration of trainings: config/study/training.yaml, one member per section.
struct LearningOptions : StudyOptions {
  PatternFeatureOptions pattern_features;  ///< section features
  PatternNetworkOptions pattern_layers;    ///< section network
  TrainingOptions training;                ///< section training
};

/// Reads the sections of training.yaml, the whole file. `options.attack` must have been read
/// before. Throws ConfigError.
void readOptions(Section& file, LearningOptions& options);

}  // namespace forge
