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
  /// [B] true: the clip has anchors; false: it has none, `ego_place` is undefined.
  torch::Tensor placed;
  torch::Tensor ego_place;     ///< [B, 2] position of the ego's box centre
  torch::Tensor ego_yaw;       ///< [B] yaw of the ego
  torch::Tensor offset;        ///< [B, 2] attacker's position in the frame of the ego's box
  torch::Tensor attacker_yaw;  ///< [B] angle between attacker's and ego's yaw, without sign
  torch::Tensor selection;     ///< [B, A] logits of the attacker; padding and ego: kAbsentLogit
};

/// Returns the signed yaw [B, A] (rad) of each agent relative to the ego at the crash, if it is the
/// attacker: `attacker_yaw` with the sign of the side from which the agent comes, negative (turned
/// to the right) if its position at t0, frame history_frames - 1 of `batch`, is to the left of the
/// predicted ego.
torch::Tensor relativeYaws(const PublishedPrediction& predicted, const TrafficBatch& batch,
                           int history_frames);

/// Runs the network on a batch of one clip that holds the history only. Called from several
/// threads.
using RunPublishedNetwork = std::function<PublishedPrediction(const TrafficBatch&)>;

/// Creates a predictor that returns one pattern per vehicle that the request allows and the
/// network's input has, most likely first (the patterns differ in the vehicle, its speed and the
/// sign of its yaw); its status is kNoCandidate without a vehicle that the request allows,
/// kRoadDoesNotAllow without an anchor. The ego's pose at the crash is always the network's, even
/// in replay mode. predict() throws std::runtime_error if the network returns values that are not
/// finite.
std::shared_ptr<const PatternPredictor> makePublishedPredictor(RunPublishedNetwork run_network,
                                                               const TrafficOptions& traffic,
                                                               const PredictionOptions& options);

}  // namespace forge
