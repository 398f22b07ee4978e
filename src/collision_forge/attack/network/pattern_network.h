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

/// One component of the predicted distribution of the ego's pose; in the ego's frame at t0.
struct EgoComponent {
  double probability = 0.0;
  Pose2 pose;               ///< mean
  double along = 0.0;       ///< m, scale of a logistic distribution along the heading
  double across = 0.0;      ///< m, the same across the heading
  Eigen::Index group = 0;   ///< index of the anchor's group: the path
  double arc_length = 0.0;  ///< m along the path, mean
};

/// The network's prediction for one candidate attacker.
struct CandidatePrediction {
  double score = 0.0;  ///< log probability that it is the attacker, plus a constant
  Pose2 offset;        ///< box centre and yaw in the ego box's frame at impact
};

/// Inference of the collision-pattern network on one CPU core, numerically equal to training.
/// Immutable; usable from many threads at once.
class PatternNetwork {
 public:
  /// `folds`: the same network trained without some scenes each. Throws std::invalid_argument if
  /// two folds leave out the same scene, and as checkWeights().
  explicit PatternNetwork(PatternWeights weights, std::vector<PatternWeights> folds = {});

  const PatternWeights& weights() const { return weights_; }
  const std::vector<std::shared_ptr<const PatternNetwork>>& folds() const {
    return folds_.models();
  }
  /// Returns the fold trained without `scene`; null if there is none.
  std::shared_ptr<const PatternNetwork> withoutScene(const std::string& scene) const {
    return folds_.withoutScene(scene);
  }

  /// Returns the encoding of a scene, PatternNetworkOptions::scene numbers. Throws
  /// std::invalid_argument if a feature matrix has the wrong size or a number is not finite.
  Eigen::VectorXf encode(const SceneFeatures& features) const;
  /// Returns the encoding of a scene and a request, the input of ego() and candidates(). `scene`
  /// comes from encode(), `request` from requestFeatures().
  Eigen::VectorXf withRequest(const Eigen::VectorXf& scene, const Eigen::VectorXf& request) const;
  /// Returns the ego's pose distribution: one component per present anchor, in the anchors' order.
  /// Throws std::runtime_error for outputs beyond the range of a trained network,
  /// std::invalid_argument if a feature is not finite.
  std::vector<EgoComponent> ego(const Eigen::VectorXf& with_request,
                                const AnchorFeatures& anchors) const;
  /// Returns one prediction per row of `features` ([candidates, kCandidateFeatures]). Throws
  /// std::runtime_error as ego().
  std::vector<CandidatePrediction> candidates(const Eigen::VectorXf& with_request,
                                              const RowMatrix& features) const;

 private:
  PatternWeights weights_;
  Folds<PatternNetwork> folds_;
};

/// Returns the geometric median of the positions (minimum expected distance), with the mean heading
/// near it. `components` must not be empty.
Pose2 medianPose(const std::vector<EgoComponent>& components);

/// Returns the log probability density (1/m2) at `position`, in the components' frame.
double logDensity(const std::vector<EgoComponent>& components, const Vector2& position);

}  // namespace forge
