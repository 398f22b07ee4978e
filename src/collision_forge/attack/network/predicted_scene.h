#pragma once

#include <optional>
#include <vector>

#include "collision_forge/attack/network/pattern_network.h"

namespace forge {

/// A snapshot as a network sees it: encoded once, asked for many instants.
class PredictedScene {
 public:
  /// Ways as long as `horizon` seconds take. Network and lanes must outlive it. Throws as
  /// sceneFeatures().
  PredictedScene(const PatternNetwork& network, const Snapshot& snapshot, const LaneIndex& lanes,
                 double horizon);

  const EgoWays& ways() const { return ways_; }
  const Snapshot& observed() const { return observed_; }

  /// Where the ego may be `tta` seconds from now, in its frame now; a component's group is its way.
  /// Without a type nothing is taken to be planned.
  std::vector<EgoComponent> egoAfter(double tta, std::optional<CollisionType> type) const;

  /// What the network says about vehicles of the snapshot, given the ego's pose at impact (frame of
  /// the ego now).
  std::vector<CandidateAnswer> judge(const std::vector<const Track*>& vehicles,
                                     const Pose2& ego_at_impact, double tta,
                                     CollisionType type) const;

 private:
  const PatternNetwork& network_;
  const LaneIndex& lanes_;
  Snapshot observed_;
  EgoWays ways_;
  Eigen::VectorXf scene_;
};

}  // namespace forge
