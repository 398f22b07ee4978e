#pragma once

#include <string>

#include "collision_forge/network/encoding_options.h"

namespace forge {

/// How the ego's pose at impact is told: by points along the ways that it may take, by points along
/// the centrelines in reach, or by one regression about driving on straight.
enum class EgoHead { kRegionProposal, kTargetPoints, kRegression };
const char* toString(EgoHead head);
/// Throws std::invalid_argument for an unknown name.
EgoHead egoHeadFromString(const std::string& name);

/// config/training.yaml, section features, where each number's unit stands. Kept in the weights.
struct PatternFeatureOptions {
  EgoHead head = EgoHead::kRegionProposal;
  int history_frames = 0;
  int agent_frames = 0;
  int max_agents = 0;
  EncodingOptions encoding;  ///< of the lanes
  int max_ways = 0;
  int way_anchors = 0;
  double spacing_floor = 0.0;
  double spacing_rate = 0.0;
  double spacing_exponent = 0.0;
  int target_lanes = 0;
  int target_points = 0;
  double target_spacing = 0.0;
};

/// config/training.yaml, section network. Kept in the weights.
struct PatternNetworkOptions {
  int hidden = 0;
  int scene = 0;
  int anchor = 0;
};

/// config/training.yaml, section training.
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
  double max_tta = 0.0;
  double min_vehicle_speed = 0.0;
  double vehicle_stride = 0.0;
  double noise_along = 0.0;
  double noise_along_exponent = 0.0;
  double noise_across = 0.0;
};

}  // namespace forge
