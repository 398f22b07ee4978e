#pragma once

#include <functional>
#include <memory>

#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/search/pattern_predictor.h"
#include "collision_forge/study/generators/traffic_batch.h"

namespace forge {

/// The output of the published network for B clips with A agents: poses at the crash in the ego's
/// frame at t0, in m and rad.
struct PublishedPrediction {
  torch::Tensor placed;        ///< [B] false: no anchors, so `ego_place` is undefined
  torch::Tensor ego_place;     ///< [B, 2] position of the ego
  torch::Tensor ego_yaw;       ///< [B]
  torch::Tensor offset;        ///< [B, 2] attacker's position in the frame of the ego's box
  torch::Tensor attacker_yaw;  ///< [B] angle between attacker's and ego's yaw, without sign
  torch::Tensor selection;     ///< [B, A] logits of the attacker; padding and ego: kAbsentLogit
};

/// Returns the signed yaw [B, A] of each agent relative to the ego, assuming it is the attacker: an
/// attacker from the left is turned to the right.
torch::Tensor relativeYaws(const PublishedPrediction& predicted, const TrafficBatch& batch,
                           int history_frames);

/// Runs the network on a batch of one clip. Called from several threads.
using RunPublishedNetwork = std::function<PublishedPrediction(const TrafficBatch&)>;

/// Creates a predictor that returns one pattern per vehicle that the request allows, most likely
/// first. The ego's position is always the network's, even in replay mode.
std::shared_ptr<const PatternPredictor> makePublishedPredictor(RunPublishedNetwork run_network,
                                                               const TrafficOptions& traffic,
                                                               const PredictionOptions& options);

}  // namespace forge
