#include "collision_forge/study/generators/strive_attack.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "collision_forge/attack/forecast/motion_estimate.h"
#include "collision_forge/attack/search/driven_answer.h"
#include "collision_forge/study/generators/generator_method.h"

// Deviations from STRIVE:
// - The attacker is given; only it approaches the ego, all other agents keep their motion.
// - It approaches at the frame of the request's time, at most `window` frames earlier, with the
//   relative heading of the requested type; STRIVE constrains neither.
// - The search starts at the mean of the prior, because no attack was recorded.
// - The ego follows the recording, or in history mode the model's expectation; no planner drives
//   it.
// - One decoding per iteration serves the ego, which is set to its given poses, and all other
//   agents.
// - "Off the road" means "far from the centre line of every lane", as in training.

namespace forge {
namespace {

using torch::Tensor;

/// One optimisation of the latent numbers, with its costs.
class LatentSearch {
 public:
  LatentSearch(StriveNetwork& network, const StriveOptions& model,
               const StriveAttackOptions& attack, const TrafficBatch& batch)
      : network_(network), model_(model), attack_(attack), batch_(batch) {
    const torch::NoGradGuard no_gradients;
    scene_ = network.encode(batch);
    prior_ = network.prior(scene_);
    const Tensor is_attacker = scene_.agent == static_cast<long>(kAttackerAgent);
    is_attacker_ = is_attacker.to(prior_.mean.options());
    is_ego_ = (scene_.agent == static_cast<long>(kEgoAgent)).to(prior_.mean.options());
  }

  /// Returns the ego's poses [1, frames, 3] for the mean of the prior.
  Tensor expectedEgo(long frames) const {
    const torch::NoGradGuard no_gradients;
    return network_.drive(scene_, prior_.mean, frames).slice(0, kEgoAgent, kEgoAgent + 1);
  }

  /// Returns the optimised poses [N, frames, 3], agents in the order of the batch. `heading`:
  /// requested relative heading of attacker and ego, rad.
  Tensor find(const Tensor& ego, double heading) {
    Tensor latent = prior_.mean.clone().set_requires_grad(true);
    torch::optim::Adam adam({latent}, torch::optim::AdamOptions(attack_.learning_rate));
    int held = 0;
    for (int i = 0; i < attack_.iterations && held < attack_.hold; ++i) {
      const Tensor poses = network_.drive(scene_, latent, ego.size(1), ego);
      held = isCrash(poses) ? held + 1 : 0;
      adam.zero_grad();
      (costOf(poses, heading) + costOf(latent)).backward();
      adam.step();
    }
    const torch::NoGradGuard no_gradients;
    return network_.drive(scene_, latent, ego.size(1), ego);
  }

 private:
  long firstFrame(long frames) const { return std::max(0L, frames - 1 - attack_.window); }

  /// Returns true if ego and attacker touch in the frames of the requested time and not before.
  bool isCrash(const Tensor& poses) const {
    const torch::NoGradGuard no_gradients;
    const Tensor deep = overlapOf(scene_, poses, model_);
    const Tensor both = (scene_.to == static_cast<long>(kEgoAgent))
                            .logical_and(scene_.from == static_cast<long>(kAttackerAgent));
    const Tensor touch = deep.index_select(0, both.nonzero().select(1, 0)).squeeze(0) > 0.0;
    const long first = firstFrame(poses.size(1));
    return touch.slice(0, first).any().item<bool>() && !touch.slice(0, 0, first).any().item<bool>();
  }

  /// Returns the costs of the distance to the requested collision, of overlaps and of leaving
  /// lanes.
  Tensor costOf(const Tensor& poses, double heading) const {
    const long first = firstFrame(poses.size(1));
    const Tensor ego = poses.select(0, kEgoAgent).slice(0, first);
    const Tensor attacker = poses.select(0, kAttackerAgent).slice(0, first);
    const Tensor square = (ego - attacker).slice(1, 0, 2).pow(2).sum(1);
    const Tensor near = torch::softmax(-(square + 1e-6).sqrt() / attack_.temperature, 0);
    const Tensor turned = attacker.select(1, 2) - ego.select(1, 2) - heading;
    const Tensor crash = attack_.crash_weight * (near * square).sum() +
                         attack_.heading_weight * (near * (1.0 - turned.cos())).sum();
    const Tensor is_other = (1.0 - is_ego_).unsqueeze(1);
    const Tensor deep = overlapOf(scene_, poses, model_) * is_other.index_select(0, scene_.to) *
                        is_other.index_select(0, scene_.from);
    const Tensor beyond =
        beyondLanes(scene_.window, batch_, poses, model_.lane_reach) / model_.length * is_other;
    return crash + attack_.overlap_weight * meanOfPositive(deep) +
           attack_.off_lanes_weight * meanOfPositive(beyond);
  }

  /// Returns the costs of unlikely latent numbers and of their distance from the start.
  Tensor costOf(const Tensor& latent) const {
    const Tensor apart = (latent - prior_.mean).pow(2);
    const Tensor unlikely = 0.5 * (apart / prior_.log_variance.exp()).sum(1);
    const Tensor prior = attack_.prior_weight +
                         (attack_.attacker_prior_weight - attack_.prior_weight) * is_attacker_;
    const Tensor stay =
        attack_.stay_weight + (attack_.attacker_stay_weight - attack_.stay_weight) * is_attacker_;
    return (prior * unlikely).mean() + (stay * apart.sum(1)).sum();
  }

  static Tensor meanOfPositive(const Tensor& numbers) {
    return numbers.sum() / (numbers > 0.0).sum().clamp_min(1);
  }

  StriveNetwork& network_;
  const StriveOptions& model_;
  const StriveAttackOptions& attack_;
  const TrafficBatch& batch_;
  StriveScene scene_;
  StriveLatent prior_;
  Tensor is_attacker_, is_ego_;
};

/// Returns the ego's recorded poses [1, frames, 3] after t0, in its frame at t0.
Tensor recordedEgo(const Future& recorded, const Pose2& ego, double now, double frame_time,
                   long frames) {
  const Tensor poses = torch::zeros({1, frames, 3});
  auto numbers = poses.accessor<float, 3>();
  for (long frame = 0; frame < frames; ++frame) {
    const auto state = stateAt(recorded.ego, now + static_cast<double>(frame + 1) * frame_time);
    const Pose2 pose = relativeTo(ego, state ? state->pose : recorded.ego.states.back().pose);
    numbers[0][frame][0] = static_cast<float>(pose.x);
    numbers[0][frame][1] = static_cast<float>(pose.y);
    numbers[0][frame][2] = static_cast<float>(pose.yaw);
  }
  return poses;
}

class StriveAttack : public AttackMethod {
 public:
  StriveAttack(std::shared_ptr<StriveNetwork> network, const StriveOptions& model,
               const StriveAttackOptions& attack, const TrafficOptions& traffic,
               const AttackOptions& options)
      : network_(std::move(network)),
        model_(model),
        attack_(attack),
        traffic_(traffic),
        options_(options) {}

  Realization answer(const Moment& moment, const CollisionRequest& request) const override {
    const Pose2 ego = estimateMotion(moment.snapshot.ego, options_.prediction.motion_frames).pose;
    return bestOfCandidates(moment, request, options_.prediction, [&](const std::string& id) {
      TrafficClip clip = trafficOf(moment.snapshot, id, request, traffic_, moment.lanes.get());
      drive(moment, request, ego, clip);
      return drivenThrough(clip, ego, id, moment, request, traffic_.history_frames - 1, options_);
    });
  }

 private:
  /// Appends the attacker's frames up to the crash.
  void drive(const Moment& moment, const CollisionRequest& request, const Pose2& ego,
             TrafficClip& clip) const {
    const int now = traffic_.history_frames - 1;
    const long frames = clip.collision_frame - now;
    const TrafficBatch batch = batchOf({{&clip, now}}, traffic_, 0);
    LatentSearch search(*network_, model_, attack_, batch);
    const double frame_time = request.tta / static_cast<double>(frames);
    const Tensor path = moment.recorded ? recordedEgo(*moment.recorded, ego, moment.snapshot.now,
                                                      frame_time, frames)
                                        : search.expectedEgo(frames);
    AgentFrames& attacker = clip.agents[kAttackerAgent];
    const bool from_left = attacker[static_cast<std::size_t>(now)]->y > 0.0;
    const double heading = (from_left ? -1.0 : 1.0) * request.bands().nominal_heading;
    const Tensor found = search.find(path, heading).contiguous();
    if (!found.isfinite().all().item<bool>()) {
      throw std::runtime_error("the search of strive_optimised returns values that are not finite");
    }
    const auto poses = found.accessor<float, 3>();
    attacker.resize(static_cast<std::size_t>(now) + 1);
    for (long frame = 0; frame < frames; ++frame) {
      const auto pose = poses[static_cast<long>(kAttackerAgent)][frame];
      attacker.push_back(Pose2{pose[0], pose[1], pose[2]});
    }
  }

  std::shared_ptr<StriveNetwork> network_;
  StriveOptions model_;
  StriveAttackOptions attack_;
  TrafficOptions traffic_;
  AttackOptions options_;
};

}  // namespace

std::unique_ptr<const AttackMethod> makeStriveAttack(std::shared_ptr<StriveNetwork> network,
                                                     const StriveOptions& model,
                                                     const StriveAttackOptions& attack,
                                                     const TrafficOptions& traffic,
                                                     const AttackOptions& options) {
  return std::make_unique<StriveAttack>(std::move(network), model, attack, traffic, options);
}

}  // namespace forge
