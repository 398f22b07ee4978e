#pragma once

#include <functional>
#include <memory>

#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/search/pattern_predictor.h"
#include "collision_forge/study/generators/traffic_batch.h"

namespace forge {

/// What the network tells of B clips with A agents. Lengths in m, angles in rad; ego's frame at
/// now.
struct PublishedTold {
  torch::Tensor placed;        ///< [B] false: there are no anchors, and the place means nothing
  torch::Tensor ego_place;     ///< [B, 2] at the crash
  torch::Tensor ego_yaw;       ///< [B]
  torch::Tensor offset;        ///< [B, 2] of the attacker, in the frame of the ego's box then
  torch::Tensor attacker_yaw;  ///< [B] how far it is turned from the ego's, to whichever side
  torch::Tensor selection;     ///< [B, A] logits; that of nobody and of the ego is kAbsentLogit
};

/// [B, A] the yaw of each agent relative to the ego's, if it is the attacker: one that comes from
/// the left is turned to the right.
torch::Tensor relativeYaws(const PublishedTold& told, const TrafficBatch& batch,
                           int history_frames);

/// What a batch of one clip is answered with; from many threads.
using TellPatterns = std::function<PublishedTold(const TrafficBatch&)>;

/// A pattern for each vehicle that the request allows, the likeliest first. The ego's place is
/// always the network's, in replay mode too.
std::shared_ptr<const PatternPredictor> makePublishedPredictor(TellPatterns tell,
                                                               const TrafficOptions& traffic,
                                                               const PredictionOptions& options);

}  // namespace forge
