#pragma once

#include <memory>

#include "collision_forge/study/generators/traffic_batch.h"

namespace forge {

/// The agents of a batch that were seen throughout the history: N of them, window after window,
/// with E pairs of two of one window. Poses in the frame of the batch.
struct StriveScene {
  torch::Tensor window;     ///< [N] of the batch
  torch::Tensor agent;      ///< [N] index in that window
  torch::Tensor to;         ///< [E] who is told
  torch::Tensor from;       ///< [E] about whom
  torch::Tensor place;      ///< [E] of whom it is about among the agents of the window
  torch::Tensor pose;       ///< [N, 3] now
  torch::Tensor speed;      ///< [N] m/s now
  torch::Tensor turn;       ///< [N] the bicycle's turn now, rad/s: yaw rate * length / speed
  torch::Tensor past;       ///< [N, feature]
  torch::Tensor map;        ///< [N, feature]
  torch::Tensor condition;  ///< [N, 6]
};

/// A normal distribution of independent numbers, [N, latent] both.
struct StriveLatent {
  torch::Tensor mean;
  torch::Tensor log_variance;
};

struct StriveMlp;
struct StriveGraphNet;

/// The nets of STRIVE's traffic model (Rempe et al., CVPR 2022, arXiv 2112.05077, Sec. 3.1 and
/// supplement).
class StriveNetwork : public torch::nn::Module {
 public:
  StriveNetwork(const StriveOptions& options, const TrafficOptions& traffic);
  ~StriveNetwork() override;

  /// Of a batch of histories.
  StriveScene encode(const TrafficBatch& history);
  /// What may come, told from the past.
  StriveLatent prior(const StriveScene& scene);
  /// The same told from what came: `future` as of the batch, with its frames of history.
  StriveLatent posterior(const StriveScene& scene, const TrafficBatch& future);
  /// The poses [N, frames, 3] that follow from `latent` [N, latent]. Where `ego` [B, frames, 3] is
  /// defined, each window's ego is put there, and the others see it so.
  torch::Tensor drive(const StriveScene& scene, const torch::Tensor& latent, long frames,
                      const torch::Tensor& ego = {});

 private:
  torch::Tensor mapFeature(const TrafficBatch& history, const StriveScene& scene);
  torch::Tensor motionFeature(const torch::Tensor& poses, const torch::Tensor& origin);

  StriveOptions options_;
  TrafficOptions traffic_;
  std::shared_ptr<StriveMlp> past_, future_, lane_point_, lane_;
  std::shared_ptr<StriveGraphNet> prior_, posterior_, decoder_;
  torch::nn::GRU memory_{nullptr};
};

/// [E, frames]: how deep two agents of a pair are in each other, as discs along their boxes: 0
/// apart, 1 where the middles of two discs meet. Poses [N, frames, 3].
torch::Tensor overlapOf(const StriveScene& scene, const torch::Tensor& poses,
                        const StriveOptions& options);

/// [N, frames]: m that the poses [N, frames, 3] of agents of the windows [N] are beyond `reach`
/// from all middles of lanes; 0 where no lane is known.
torch::Tensor beyondLanes(const torch::Tensor& window, const TrafficBatch& batch,
                          const torch::Tensor& poses, double reach);

}  // namespace forge
