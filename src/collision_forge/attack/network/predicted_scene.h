#pragma once

#include <optional>
#include <vector>

#include "collision_forge/attack/network/pattern_network.h"

namespace forge {

/// A snapshot encoded once by the network and queried for many times after t0. Immutable.
class PredictedScene {
 public:
  /// Candidate paths cover `horizon` s; later times are predicted on their straight extensions.
  /// `network` and `lanes` must outlive this object; `snapshot` is copied. Throws as
  /// sceneFeatures().
  PredictedScene(const PatternNetwork& network, const Snapshot& snapshot, const LaneIndex& lanes,
                 double horizon);

  /// Returns the ego's candidate paths, most probable first.
  const EgoPathSet& ways() const { return ways_; }
  /// Returns the snapshot without information from later frames, see observedSnapshot().
  const Snapshot& observed() const { return observed_; }

  /// Returns the distribution of the ego's pose `tta` s after t0, in its frame at t0; a component's
  /// group is the index of its path in ways() (for the head kRegionProposal). Without `type`, the
  /// prediction is not conditioned on a crash. Throws as anchorFeatures() and
  /// PatternNetwork::ego().
  std::vector<EgoComponent> egoAfter(double tta, std::optional<CollisionType> type) const;

  /// Returns the network's prediction for each vehicle, in the order of `vehicles` (empty for
  /// none), given the ego's pose at impact `tta` s after t0 (`ego_at_impact`, ego frame at t0).
  /// Only the vehicles' ids are used. Throws std::invalid_argument if a vehicle is not in the
  /// snapshot, and as PatternNetwork::candidates().
  std::vector<CandidatePrediction> judge(const std::vector<const Track*>& vehicles,
                                         const Pose2& ego_at_impact, double tta,
                                         CollisionType type) const;

 private:
  const PatternNetwork& network_;
  const LaneIndex& lanes_;
  Snapshot observed_;
  EgoPathSet ways_;
  Eigen::VectorXf scene_;
};

}  // namespace forge
