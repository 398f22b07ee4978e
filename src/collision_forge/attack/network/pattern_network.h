#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision_forge/attack/forecast/folds.h"
#include "collision_forge/attack/network/anchor_features.h"
#include "collision_forge/attack/network/pattern_weights.h"
#include "collision_forge/attack/network/request_features.h"
#include "collision_forge/attack/network/scene_features.h"

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
  /// `folds` were trained like it, but left some scenes out each; no scene is left out twice.
  /// Throws std::invalid_argument otherwise and as checkWeights().
  explicit PatternNetwork(PatternWeights weights, std::vector<PatternWeights> folds = {});

  const PatternWeights& weights() const { return weights_; }
  const std::vector<std::shared_ptr<const PatternNetwork>>& folds() const {
    return folds_.models();
  }
  /// The fold that left the scene out; null when none did.
  std::shared_ptr<const PatternNetwork> withoutScene(const std::string& scene) const {
    return folds_.withoutScene(scene);
  }

  /// Throws std::invalid_argument for features of another size or with a number that is not finite.
  Eigen::VectorXf encode(const SceneFeatures& features) const;
  Eigen::VectorXf withRequest(const Eigen::VectorXf& scene, const Eigen::VectorXf& request) const;
  // The answers. Throw std::runtime_error for numbers that no trained network gives.
  /// Most probable first is not promised; the order is that of the anchors that are there.
  std::vector<EgoComponent> ego(const Eigen::VectorXf& with_request,
                                const AnchorFeatures& anchors) const;
  std::vector<CandidateAnswer> candidates(const Eigen::VectorXf& with_request,
                                          const RowMatrix& features) const;

 private:
  PatternWeights weights_;
  Folds<PatternNetwork> folds_;
};

/// The pose with the least expected distance, headed as what is expected there.
Pose2 medianPose(const std::vector<EgoComponent>& components);

/// Logarithm of the density (1/m2) at a position.
double logDensity(const std::vector<EgoComponent>& components, const Vector2& position);

}  // namespace forge
