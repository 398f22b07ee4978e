#include "collision_forge/attack/network/predicted_scene.h"

#include <algorithm>
#include <stdexcept>

#include "collision_forge/base/scene/find_track.h"

namespace forge {

PredictedScene::PredictedScene(const PatternNetwork& network, const Snapshot& snapshot,
                               const LaneIndex& lanes, double horizon)
    : network_(network),
      lanes_(lanes),
      observed_(observedSnapshot(snapshot, {})),
      ways_(egoPathSet(observed_, lanes, horizon, network.weights().features.max_ways)),
      scene_(network.encode(sceneFeatures(observed_, lanes, network.weights().features))) {}

std::vector<EgoComponent> PredictedScene::egoAfter(double tta,
                                                   std::optional<CollisionType> type) const {
  const AnchorFeatures anchors = anchorFeatures(ways_, lanes_, tta, network_.weights().features);
  return network_.ego(network_.withRequest(scene_, requestFeatures(type, tta)), anchors);
}

std::vector<CandidatePrediction> PredictedScene::judge(const std::vector<const Track*>& vehicles,
                                                       const Pose2& ego_at_impact, double tta,
                                                       CollisionType type) const {
  RowMatrix features(static_cast<Eigen::Index>(vehicles.size()), kCandidateFeatures);
  for (std::size_t i = 0; i < vehicles.size(); ++i) {
    const Track* known = findTrack(observed_.agents, vehicles[i]->id);
    if (!known) {
      throw std::invalid_argument("agent " + vehicles[i]->id + " is not in the snapshot");
    }
    features.row(static_cast<Eigen::Index>(i)) =
        candidateFeatures(candidateNow(*known, ways_.ego.state.pose), ways_.ego.past_speeds[0],
                          ego_at_impact, tta, type)
            .transpose();
  }
  return network_.candidates(network_.withRequest(scene_, requestFeatures(type, tta)), features);
}

}  // namespace forge
