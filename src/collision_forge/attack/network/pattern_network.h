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

/// One component of the predicted distribution of the ego's box centre; in the frame of the ego's
/// box at t0.
struct EgoComponent {
  double probability = 0.0;  ///< of the component, 0..1; all sum to 1
  Pose2 pose;                ///< mean
  /// m, scale of a logistic distribution of the position along the heading of `pose`
  double along = 0.0;
  double across = 0.0;      ///< m, the same across that heading
  Eigen::Index group = 0;   ///< index of the anchor's row in AnchorFeatures::groups: the path
  double arc_length = 0.0;  ///< m along the path, mean; 0 if anchors lie on no path
};

/// The network's prediction for one candidate attacker.
struct CandidatePrediction {
  double score = 0.0;  ///< log probability that it is the attacker, plus a constant that is equal
                       ///< for all candidates of a call
  Pose2 offset;        ///< attacker's box centre and yaw in the ego box's frame at impact
};

/// Inference of the collision-pattern network on one CPU core, numerically equal to training.
/// Immutable; usable from many threads at once.
class PatternNetwork {
 public:
  /// `folds`: the same network trained without some scenes each. Throws std::invalid_argument if
  /// two folds leave out the same scene, and as checkWeights().
  explicit PatternNetwork(PatternWeights weights, std::vector<PatternWeights> folds = {});

  /// Returns the weights of the network itself, not of a fold.
  const PatternWeights& weights() const { return weights_; }
  /// Returns the networks trained without some scenes, in the order of the constructor.
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
  /// Returns the encoding of a scene and a request, the input of ego() and candidates(), again
  /// PatternNetworkOptions::scene numbers. `scene` comes from encode(), `request` from
  /// requestFeatures(); sizes are not checked.
  Eigen::VectorXf withRequest(const Eigen::VectorXf& scene, const Eigen::VectorXf& request) const;
  /// Returns the ego's pose distribution: one component per present anchor, in the anchors' order;
  /// at least one must be present. Throws std::runtime_error for outputs beyond the range of a
  /// trained network, std::invalid_argument if a feature is not finite.
  std::vector<EgoComponent> ego(const Eigen::VectorXf& with_request,
                                const AnchorFeatures& anchors) const;
  /// Returns one prediction per row of `features` ([candidates, kCandidateFeatures], each from
  /// candidateFeatures()), in their order; none for no row. Throws std::runtime_error as ego().
  std::vector<CandidatePrediction> candidates(const Eigen::VectorXf& with_request,
                                              const RowMatrix& features) const;

 private:
  PatternWeights weights_;
  Folds<PatternNetwork> folds_;
};

/// Returns the geometric median of the positions (minimum expected distance), with the mean heading
/// of the components near it (weight halved at 2 m), in the components' frame. `components` must
/// not be empty.
Pose2 medianPose(const std::vector<EgoComponent>& components);

/// Returns the log probability density (1/m2) at `position` (m, in the components' frame), at least
/// log(1e-30).
double logDensity(const std::vector<EgoComponent>& components, const Vector2& position);

}  // namespace forge
