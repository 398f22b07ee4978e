#include "collision_forge/study/generators/strive.h"

#include <algorithm>

#include "collision_forge/study/generators/strive_network.h"

// Deviations from STRIVE, which has 4 frames of history and 12 of future instead of 8 and 4:
// - The map input is the nearest lane pieces at t0, not an image around each predicted pose. So
//   "off the road" means "far from the centre line of every lane".
// - Agents that are not observed in the whole history are omitted. All have one size and class.
// - Overlaps of ego and attacker are not penalised, because they are requested.
// - The attacker has a higher weight, because only its motion is altered in the clips.
// - The learning rate is far higher, with correspondingly fewer steps. Type and time of the request
//   are input of the decoder only (arXiv 2510.12206, Sec. 4).

namespace forge {
namespace {

using torch::Tensor;

Tensor drawn(const StriveLatent& latent, const Tensor& noise) {
  return latent.mean + (0.5 * latent.log_variance).exp() * noise;
}

/// Returns the KL divergence of `from` from `to`, summed over the latent numbers of each agent.
Tensor divergence(const StriveLatent& from, const StriveLatent& to) {
  const Tensor apart = (from.mean - to.mean).pow(2) + from.log_variance.exp();
  return 0.5 *
         (to.log_variance - from.log_variance + apart / to.log_variance.exp() - 1.0).sum(1).mean();
}

/// Returns the mean weighted by `counted`.
Tensor meanOf(const Tensor& numbers, const Tensor& counted) {
  return (numbers * counted).sum() / counted.sum().clamp_min(1.0);
}

class Strive : public TrafficGenerator {
 public:
  Strive(const StriveOptions& options, const TrafficOptions& traffic, torch::Device device)
      : TrafficGenerator(traffic),
        options_(options),
        device_(device),
        network_(std::make_shared<StriveNetwork>(options, traffic)),
        adam_(network_->parameters(), torch::optim::AdamOptions(options.learning_rate)) {
    network_->to(device);
  }

  Tensor predict(const TrafficBatch& history, torch::Generator noise) const override {
    const StriveScene scene = network_->encode(history);
    const StriveLatent prior = network_->prior(scene);
    const Tensor random = torch::randn({scene.pose.size(0), options_.latent}, noise).to(device_);
    const Tensor driven = network_->drive(scene, drawn(prior, random), traffic().future_frames);
    const long windows = history.poses.size(0);
    const long agents = history.poses.size(1);
    return torch::zeros({windows, agents, traffic().future_frames, 3}, driven.options())
        .index_put({scene.window, scene.agent}, driven);
  }

  std::vector<std::string> lossNames() const override {
    return {"reconstruction", "divergence", "overlap", "off_lanes"};
  }

  std::vector<double> trainStep(const TrafficBatch& batch) override {
    const TrafficBatch history = historyOf(batch, traffic().history_frames);
    const StriveScene scene = network_->encode(history);
    const StriveLatent prior = network_->prior(scene);
    const StriveLatent posterior = network_->posterior(scene, batch);
    const Tensor reconstructed = drive(scene, posterior);
    const Tensor free = drive(scene, prior);
    const Tensor reconstruction = reconstructionOf(scene, batch, reconstructed);
    const Tensor kl = divergence(posterior, prior);
    const Tensor overlap = overlapOfOthers(scene, free);
    const Tensor off_lanes = egoOffLanes(scene, history, free);
    const double ramp = std::min(1.0, static_cast<double>(++steps_) / options_.divergence_steps);
    const Tensor loss = reconstruction + ramp * options_.divergence_weight * kl +
                        options_.overlap_weight * overlap + options_.off_lanes_weight * off_lanes;
    adam_.zero_grad();
    loss.backward();
    torch::nn::utils::clip_grad_norm_(network_->parameters(), options_.max_gradient);
    adam_.step();
    return {reconstruction.item<double>(), kl.item<double>(), overlap.item<double>(),
            off_lanes.item<double>()};
  }

  int epochs() const override { return options_.epochs; }
  int batchSize() const override { return options_.batch; }
  std::shared_ptr<torch::nn::Module> network() const override { return network_; }

  void saveTraining(torch::serialize::OutputArchive& archive) const override {
    torch::serialize::OutputArchive adam;
    adam_.save(adam);
    archive.write("adam", adam);
    archive.write("steps", torch::tensor(steps_));
  }

  void loadTraining(torch::serialize::InputArchive& archive) override {
    torch::serialize::InputArchive adam;
    Tensor steps;
    archive.read("adam", adam);
    archive.read("steps", steps);
    adam_.load(adam);
    steps_ = steps.item<std::int64_t>();
  }

 private:
  Tensor drive(const StriveScene& scene, const StriveLatent& latent) const {
    return network_->drive(scene, drawn(latent, torch::randn_like(latent.mean)),
                           traffic().future_frames);
  }

  /// Returns the negative log of a normal density of positions and headings, up to a constant.
  Tensor reconstructionOf(const StriveScene& scene, const TrafficBatch& batch,
                          const Tensor& driven) const {
    const Tensor came =
        batch.poses.index({scene.window, scene.agent}).slice(1, traffic().history_frames);
    const Tensor seen =
        batch.seen.index({scene.window, scene.agent}).slice(1, traffic().history_frames);
    const Tensor apart = (driven - came).slice(2, 0, 2) / options_.position_scale;
    const Tensor turned = driven.select(2, 2) - came.select(2, 2);
    const Tensor far = 0.5 * apart.pow(2).sum(2) + (1.0 - turned.cos());
    const Tensor is_attacker =
        (scene.agent == static_cast<long>(kAttackerAgent)).to(seen.options()).unsqueeze(1);
    return meanOf(far, seen * (1.0 + (options_.attacker_weight - 1.0) * is_attacker));
  }

  /// Returns the mean overlap of all pairs of agents except ego and attacker.
  Tensor overlapOfOthers(const StriveScene& scene, const Tensor& driven) const {
    const Tensor apart = overlapOf(scene, driven, options_);
    const Tensor last =
        scene.agent.index_select(0, scene.to).maximum(scene.agent.index_select(0, scene.from));
    const Tensor strangers =
        (last > static_cast<long>(kAttackerAgent)).to(apart.options()).unsqueeze(1);
    return meanOf(apart, strangers.expand_as(apart));
  }

  Tensor egoOffLanes(const StriveScene& scene, const TrafficBatch& history,
                     const Tensor& driven) const {
    const Tensor egos = (scene.agent == static_cast<long>(kEgoAgent)).nonzero().select(1, 0);
    return beyondLanes(scene.window.index_select(0, egos), history, driven.index_select(0, egos),
                       options_.lane_reach)
               .mean() /
           options_.length;
  }

  StriveOptions options_;
  torch::Device device_;
  std::shared_ptr<StriveNetwork> network_;
  torch::optim::Adam adam_;
  std::int64_t steps_ = 0;
};

}  // namespace

std::shared_ptr<TrafficGenerator> makeStrive(const StriveOptions& options,
                                             const TrafficOptions& traffic, torch::Device device) {
  return std::make_shared<Strive>(options, traffic, device);
}

}  // namespace forge
