#pragma once

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "collision_forge/network/anchor_features.h"
#include "collision_forge/network/pattern_weights.h"
#include "collision_forge/network/request_features.h"
#include "collision_forge/network/scene_features.h"

namespace forge {

/// One place that the ego may come to. Frame of the ego now.
struct EgoComponent {
  double probability = 0.0;
  Pose2 pose;          ///< expected
  double along = 0.0;  ///< m, scale of a logistic distribution along the heading
  double across = 0.0;
  Eigen::Index group = 0;   ///< of the anchors: the way
  double arc_length = 0.0;  ///< m along the way, expected
};

/// What the head says about one candidate.
struct CandidateAnswer {
  double score = 0.0;  ///< logarithm of how likely it is the attacker, up to a common number
  Pose2 offset;        ///< of its box in the ego box's frame at impact
};

/// The network as a function of features, on one core; the same numbers as training has. Immutable.
class PatternNetwork {
 public:
  /// Throws as checkWeights().
  explicit PatternNetwork(PatternWeights weights);

  const PatternWeights& weights() const { return weights_; }

  /// Throws std::invalid_argument for features of another size or with a number that is not finite.
  Eigen::VectorXf encode(const SceneFeatures& features) const;
  Eigen::VectorXf withRequest(const Eigen::VectorXf& scene, const Eigen::VectorXf& request) const;
  /// Most probable first is not promised; the order is that of the anchors that are there.
  std::vector<EgoComponent> ego(const Eigen::VectorXf& with_request,
                                const AnchorFeatures& anchors) const;
  std::vector<CandidateAnswer> candidates(const Eigen::VectorXf& with_request,
                                          const RowMatrix& features) const;

 private:
  PatternWeights weights_;
};

/// The pose with the least expected distance, headed as what is expected there.
Pose2 medianPose(const std::vector<EgoComponent>& components);

/// Logarithm of the density (1/m2) at a position.
double logDensity(const std::vector<EgoComponent>& components, const Vector2& position);

/// A network for all scenes, and for a scene on test the one that was trained without it.
class PatternNetworks {
 public:
  /// The first is for all scenes. Throws std::invalid_argument for none, and for a scene that two
  /// of the others left out.
  explicit PatternNetworks(std::vector<PatternWeights> weights);

  const PatternNetwork& forScene(const std::string& name) const;
  const std::vector<PatternNetwork>& all() const { return networks_; }

 private:
  std::vector<PatternNetwork> networks_;
  std::unordered_map<std::string, std::size_t> fold_of_;
};

}  // namespace forge
