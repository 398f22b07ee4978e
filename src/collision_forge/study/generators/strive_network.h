#pragma once

#include <memory>

#include "collision_forge/study/generators/traffic_batch.h"

namespace forge {

/// The N agents of a batch that are observed in the whole history, window by window, with E ordered
/// pairs of agents of the same window (graph edges). Poses (x, y in m, yaw in rad) are in the frame
/// of the batch, the one of each window's ego at t0.
struct StriveScene {
  torch::Tensor window;  ///< [N] index of the window in the batch
  torch::Tensor agent;   ///< [N] index of the agent in that window
  torch::Tensor to;      ///< [E] receiving agent, index into [N]
  torch::Tensor from;    ///< [E] sending agent, index into [N]
  torch::Tensor place;   ///< [E] index of the sender among the N agents of its window, from 0
  torch::Tensor pose;    ///< [N, 3] at t0, m and rad
  torch::Tensor speed;   ///< [N] m/s at t0
  /// [N] at t0, state of the bicycle, without unit: yaw rate (rad/s) * StriveOptions::length (m) /
  /// speed (m/s). Speeds below 2 m/s, and standing agents, count as 2 m/s; limited to +-2 pi.
  torch::Tensor turn;
  torch::Tensor past;       ///< [N, feature] learned feature of the agent's history
  torch::Tensor map;        ///< [N, feature] learned feature of the lanes around it
  torch::Tensor condition;  ///< [N, 6], TrafficBatch::condition of the agent's window
};

/// A normal distribution with independent components; both tensors [N, latent].
struct StriveLatent {
  torch::Tensor mean;          ///< mean of each component
  torch::Tensor log_variance;  ///< natural logarithm of the variance of each component
};

struct StriveMlp;
struct StriveGraphNet;

/// The networks of STRIVE's traffic model (Rempe et al., CVPR 2022, arXiv 2112.05077, Sec. 3.1 and
/// supplement).
class StriveNetwork : public torch::nn::Module {
 public:
  /// Creates the layers with random weights from libtorch's generator.
  StriveNetwork(const StriveOptions& options, const TrafficOptions& traffic);
  ~StriveNetwork() override;

  /// Returns a batch of histories (historyOf()) encoded. In training mode, adds
  /// StriveOptions::noise.
  StriveScene encode(const TrafficBatch& history);
  /// Returns the distribution of the latent of each agent given the history.
  StriveLatent prior(const StriveScene& scene);
  /// Returns the distribution of the latent given history and future. `future`: the batch of
  /// `scene` with history and future frames. An agent of `scene` need not be observed in the
  /// future: its unobserved frames count as zeros, with a flag.
  StriveLatent posterior(const StriveScene& scene, const TrafficBatch& future);
  /// Returns the poses [N, frames, 3] after t0, at 2 Hz, of agents that drive as kinematic bicycles
  /// with the controls that the decoder derives from `latent` [N, latent].
  torch::Tensor drive(const StriveScene& scene, const torch::Tensor& latent, long frames);

 private:
  /// Returns StriveScene::map.
  torch::Tensor mapFeature(const TrafficBatch& history, const StriveScene& scene);
  /// Returns the scaled motion [N, T, 6] of poses [N, T, 3] relative to `origin` [N, 3]: x, y, cos
  /// and sin of the yaw, speed, turn.
  torch::Tensor motionFeature(const torch::Tensor& poses, const torch::Tensor& origin);

  StriveOptions options_;
  TrafficOptions traffic_;
  std::shared_ptr<StriveMlp> past_, future_, lane_point_, lane_;
  std::shared_ptr<StriveGraphNet> prior_, posterior_, decoder_;
  torch::nn::GRU memory_{nullptr};
};

/// Returns the overlap [E, frames] of the pairs of agents (`scene.to`, `scene.from`), approximated
/// by five discs along their boxes (diameter `options.width`): 1 minus the smallest distance of two
/// centres over the diameter, but at least 0: 0 if apart, 1 if two centres coincide. `poses`: [N,
/// frames, 3].
torch::Tensor overlapOf(const StriveScene& scene, const torch::Tensor& poses,
                        const StriveOptions& options);

/// Returns how far (m, [N, frames]) the poses [N, frames, 3] are beyond `reach` (m) from the
/// nearest point of a lane piece of their window; 0 within `reach` and without lanes. `window` [N]:
/// index of each agent's window in the batch.
torch::Tensor beyondLanes(const torch::Tensor& window, const TrafficBatch& batch,
                          const torch::Tensor& poses, double reach);

}  // namespace forge
