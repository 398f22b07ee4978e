#include "collision_forge/study/generators/mid.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace forge {
namespace {

using torch::Tensor;
namespace nn = torch::nn;

constexpr long kStateNumbers = 6;          // x, y, their velocity, their acceleration
constexpr double kPositionBase = 10000.0;  // base of the sinusoidal position encoding

/// Returns vectors [N, T, 2 k] with each pair of numbers rotated by `angle` [N].
Tensor turned(const Tensor& vectors, const Tensor& angle) {
  const Tensor cos = angle.cos().view({-1, 1, 1});
  const Tensor sin = angle.sin().view({-1, 1, 1});
  const Tensor pairs = vectors.view({vectors.size(0), vectors.size(1), -1, 2});
  const Tensor x = pairs.select(3, 0);
  const Tensor y = pairs.select(3, 1);
  return torch::stack({cos * x - sin * y, sin * x + cos * y}, 3).flatten(2);
}

/// Returns [B, A, T, 6]: positions, velocities, accelerations in m, m/s and m/s^2. Uses backward
/// differences, because there is no frame after t0 (MID uses central ones); the first velocity is a
/// copy of the second.
Tensor statesOf(const Tensor& poses) {
  const Tensor places = poses.slice(3, 0, 2);
  const Tensor steps = places.diff(1, 2) / kFrameInterval;
  const Tensor velocities = torch::cat({steps.slice(2, 0, 1), steps}, 2);
  const Tensor changes = velocities.diff(1, 2) / kFrameInterval;
  const Tensor accelerations = torch::cat({torch::zeros_like(changes.slice(2, 0, 1)), changes}, 2);
  return torch::cat({places, velocities, accelerations}, 3);
}

/// N agents of a batch, each in its own frame at t0, with x along its heading. MID uses world axes
/// and rotated copies of the data, which this frame makes unnecessary.
struct Drivers {
  Tensor rows;       // [N] into B x A
  Tensor pose;       // [N, 3] at t0, in the batch's frame
  Tensor velocity;   // [N, 1, 2] m/s at t0
  Tensor own;        // [N, T, 6] states, in units of the scales
  Tensor others;     // [N, T, 6] sum of the neighbours' states, relative to `pose`
  Tensor company;    // [N, 1] 1 for an agent with a neighbour, else 0
  Tensor condition;  // [N, 6]
};

/// Returns [B, A, A] with 1 if the second agent is a neighbour of the first, by the distance at t0.
/// Trajectron++ fades neighbours in over four frames.
Tensor neighboursOf(const Tensor& places, const Tensor& there, double reach) {
  const Tensor apart = (places.unsqueeze(1) - places.unsqueeze(2)).norm(2, 3);
  const Tensor other = 1.0 - torch::eye(places.size(1), places.options());
  return (apart < reach) * other * there.unsqueeze(1);
}

/// Returns the agents of a history selected by `picked` [B, A]; agents in `there` [B, A] can be
/// their neighbours.
Drivers driversOf(const TrafficBatch& history, const Tensor& picked, const Tensor& there,
                  const MidOptions& options) {
  const Tensor states = statesOf(history.poses);
  const long now = states.size(2) - 1;
  const Tensor state = states.slice(2, now);
  const Tensor near = neighboursOf(state.squeeze(2).slice(2, 0, 2), there, options.neighbour_reach);
  const Tensor count = near.sum(2);
  const Tensor others =
      near.bmm(states.flatten(2)).view_as(states) - count.unsqueeze(2).unsqueeze(3) * state;
  const Tensor scale = torch::tensor(
      {options.position_scale, options.position_scale, options.velocity_scale,
       options.velocity_scale, options.acceleration_scale, options.acceleration_scale},
      states.options());
  const Tensor rows = picked.flatten().nonzero().squeeze(1);
  const auto of = [&](const Tensor& agents) { return agents.flatten(0, 1).index_select(0, rows); };
  const Tensor pose = of(history.poses.select(2, now));
  const Tensor back = -pose.select(1, 2);
  const Tensor place = torch::constant_pad_nd(state.slice(3, 0, 2), {0, kStateNumbers - 2});
  const Tensor condition = history.condition.unsqueeze(1).expand({-1, states.size(1), -1});
  return {rows,
          pose,
          turned(of(state.slice(3, 2, 4)), back),
          turned(of(states - place), back) / scale,
          turned(of(others), back) / scale,
          of(count).clamp_max(1.0).unsqueeze(1),
          of(condition)};
}

/// The paper's context layer: a linear layer, gated and shifted by the context of the agent, which
/// is computed once for all its tokens.
struct GatedLayer : nn::Module {
  GatedLayer(long from, long to, long context) {
    layer = register_module("layer", nn::Linear(from, to));
    gate = register_module("gate", nn::Linear(context, to));
    shift = register_module("shift", nn::Linear(nn::LinearOptions(context, to).bias(false)));
  }

  /// Maps [F, N, from] and [N, context] to [F, N, to].
  Tensor forward(const Tensor& tokens, const Tensor& context) {
    return layer(tokens) * torch::sigmoid(gate(context)) + shift(context);
  }

  nn::Linear layer{nullptr}, gate{nullptr}, shift{nullptr};
};

/// Returns the sinusoidal encoding of the frame numbers, [F, 1, width].
Tensor frameNumbers(long frames, long width) {
  const Tensor powers = torch::arange(0, width, 2) * (-std::log(kPositionBase) / width);
  const Tensor angles = torch::arange(frames).unsqueeze(1) * powers.exp();
  return torch::stack({angles.sin(), angles.cos()}, 2).view({frames, 1, width});
}

/// Trajectron++'s encoder of histories and MID's transformer, which predicts the noise in a future.
struct Denoiser : nn::Module {
  Denoiser(const MidOptions& options, long future_frames) : options(options) {
    const auto recurrent = [&](long from) {
      return nn::LSTM(nn::LSTMOptions(from, options.encoder).batch_first(true));
    };
    const long width = options.width;
    const long context = 3 + 2 * options.encoder + kConditionNumbers;
    own_encoder = register_module("own_encoder", recurrent(kStateNumbers));
    others_encoder = register_module("others_encoder", recurrent(2 * kStateNumbers));
    const auto gated = [&](const char* name, long from, long to) {
      return register_module(name, std::make_shared<GatedLayer>(from, to, context));
    };
    input = gated("input", 2, width);
    output_1 = gated("output_1", width, width / 2);
    output_2 = gated("output_2", width / 2, width / 4);
    output_3 = gated("output_3", width / 4, 2);
    const nn::TransformerEncoderLayer layer(nn::TransformerEncoderLayerOptions(width, options.heads)
                                                .dim_feedforward(options.feed_forward)
                                                .dropout(options.dropout));
    transformer = register_module(
        "transformer",
        nn::TransformerEncoder(nn::TransformerEncoderOptions(layer, options.layers)));
    frame_numbers = register_buffer("frame_numbers", frameNumbers(future_frames, width));
  }

  /// Returns the context [N, 2 encoder + 6], computed once for all denoising steps. Trajectron++'s
  /// attention over classes of neighbours is omitted, because there is only one class here.
  Tensor contextOf(const Drivers& drivers) {
    const auto last = [&](nn::LSTM& encoder, const Tensor& states) {
      return torch::dropout(std::get<0>(encoder(states)).select(1, states.size(1) - 1),
                            options.encoder_dropout, is_training());
    };
    const Tensor beside = torch::cat({drivers.others, drivers.own}, 2);
    return torch::cat({last(others_encoder, beside) * drivers.company,
                       last(own_encoder, drivers.own), drivers.condition},
                      1);
  }

  /// Returns the predicted noise in `noised` [F, N, 2] at diffusion steps with `beta` [N, 1];
  /// frames set in `unknown` [N, F] are ignored. The input is beta divided by the last beta; MID
  /// uses beta itself, at most 0.05, with which training is slower.
  Tensor noiseIn(const Tensor& noised, const Tensor& beta, const Tensor& context,
                 const Tensor& unknown) {
    const Tensor share = beta / options.beta_last;
    const Tensor inputs = torch::cat({share, share.sin(), share.cos(), context}, 1);
    const Tensor tokens = torch::dropout(input->forward(noised, inputs) + frame_numbers,
                                         options.dropout, is_training());
    const Tensor seen = transformer(tokens, Tensor(), unknown);
    return output_3->forward(output_2->forward(output_1->forward(seen, inputs), inputs), inputs);
  }

  MidOptions options;
  nn::LSTM own_encoder{nullptr}, others_encoder{nullptr};
  std::shared_ptr<GatedLayer> input, output_1, output_2, output_3;
  nn::TransformerEncoder transformer{nullptr};
  Tensor frame_numbers;
};

class Mid : public TrafficGenerator {
 public:
  Mid(const MidOptions& options, const TrafficOptions& traffic, torch::Device device)
      : TrafficGenerator(traffic),
        options_(options),
        schedule_(noiseSchedule(options)),
        device_(device),
        denoiser_(std::make_shared<Denoiser>(options, traffic.future_frames)),
        optimizer_(denoiser_->parameters(), torch::optim::AdamOptions(options.learning_rate)) {
    denoiser_->to(device);
    denoiser_->eval();
  }

  Tensor predict(const TrafficBatch& history, torch::Generator noise) const override {
    const torch::NoGradGuard no_gradients;
    const long now = history.poses.size(2) - 1;
    const Tensor there = seenThroughout(history, static_cast<int>(now) + 1);
    const Drivers drivers = driversOf(history, there, there, options_);
    const Tensor drawn = denoised(drivers, noise).transpose(0, 1);  // [N, F, 2]
    if (!drawn.isfinite().all().item<bool>()) {
      throw std::runtime_error(
          "the diffusion of c_mid returns values that are not finite: its weights are damaged");
    }
    const Tensor velocities = drivers.velocity + options_.target_scale * drawn;
    const Tensor driven = kFrameInterval * turned(velocities, drivers.pose.select(1, 2));
    const Tensor pose = history.poses.select(2, now);
    const long frames = traffic().future_frames;
    const Tensor steps = torch::zeros({pose.size(0) * pose.size(1), frames, 2}, pose.options())
                             .index_copy(0, drivers.rows, driven)
                             .view({pose.size(0), pose.size(1), frames, 2});
    const Tensor places = pose.slice(2, 0, 2).unsqueeze(2) + steps.cumsum(2);
    const Tensor yaws = yawsAlong(steps, pose.select(2, 2), traffic().min_step);
    return torch::cat({places, yaws.unsqueeze(3)}, 3);
  }

  std::vector<std::string> lossNames() const override { return {"noise"}; }

  std::vector<double> trainStep(const TrafficBatch& batch) override {
    const Tensor loss = lossOn(batch);
    if (!loss.isfinite().item<bool>()) {
      throw std::runtime_error(
          "the loss of c_mid is not finite: its learning_rate is too large or its input is "
          "damaged");
    }
    optimizer_.zero_grad();
    loss.backward();
    optimizer_.step();
    return {loss.item<double>()};
  }

  int epochs() const override { return options_.epochs; }
  int batchSize() const override { return options_.batch; }
  std::shared_ptr<nn::Module> network() const override { return denoiser_; }

  void saveTraining(torch::serialize::OutputArchive& archive) const override {
    optimizer_.save(archive);
  }
  void loadTraining(torch::serialize::InputArchive& archive) override { optimizer_.load(archive); }

 private:
  /// Returns samples [F, N, 2], drawn by DDIM, or by DDPM if no step of the diffusion is skipped.
  Tensor denoised(const Drivers& drivers, torch::Generator& noise) const {
    const Tensor context = denoiser_->contextOf(drivers);
    const long agents = drivers.rows.size(0);
    const auto draw = [&] {
      return torch::randn({traffic().future_frames, agents, 2}, noise).to(device_);
    };
    const int stride = options_.diffusion_steps / options_.sampling_steps;
    Tensor noised = draw();
    for (int t = options_.diffusion_steps; t > 0; t -= stride) {
      const auto at = static_cast<std::size_t>(t);
      const Tensor beta = torch::full({agents, 1}, schedule_.beta[at], context.options());
      const Tensor found = denoiser_->noiseIn(noised, beta, context, {});
      noised = stride > 1 ? byDdim(noised, found, t, t - stride) : byDdpm(noised, found, t);
      if (stride == 1 && t > 1) noised = noised + spreadAt(t) * draw();
    }
    return noised;
  }

  /// Denoises deterministically from step t to an earlier one (Song et al. 2021, arXiv 2010.02502,
  /// eta 0).
  Tensor byDdim(const Tensor& noised, const Tensor& found, int t, int earlier) const {
    const double from = schedule_.alpha_bar[static_cast<std::size_t>(t)];
    const double to = schedule_.alpha_bar[static_cast<std::size_t>(earlier)];
    const Tensor signal = (noised - std::sqrt(1.0 - from) * found) / std::sqrt(from);
    return std::sqrt(to) * signal + std::sqrt(1.0 - to) * found;
  }

  /// Returns the mean at step t - 1 (Ho et al. 2020, arXiv 2006.11239).
  Tensor byDdpm(const Tensor& noised, const Tensor& found, int t) const {
    const auto at = static_cast<std::size_t>(t);
    const double beta = schedule_.beta[at];
    return (noised - beta / std::sqrt(1.0 - schedule_.alpha_bar[at]) * found) /
           std::sqrt(1.0 - beta);
  }

  /// Returns the standard deviation around that mean.
  double spreadAt(int t) const {
    const auto at = static_cast<std::size_t>(t);
    return std::sqrt(schedule_.beta[at] * (1.0 - schedule_.alpha_bar[at - 1]) /
                     (1.0 - schedule_.alpha_bar[at]));
  }

  /// Returns the diffused quantity [F, N, 2]: future velocities minus the velocity at t0, in the
  /// agent's frame. MID diffuses the unscaled velocities. For cars this loses their mean: some of
  /// it is left in the last step of the diffusion, while sampling starts from zero mean.
  Tensor targetOf(const TrafficBatch& batch, const Drivers& drivers) const {
    const Tensor places = batch.poses.slice(2, traffic().history_frames - 1).slice(3, 0, 2);
    const Tensor came = (places.diff(1, 2) / kFrameInterval).flatten(0, 1);
    const Tensor own = turned(came.index_select(0, drivers.rows), -drivers.pose.select(1, 2));
    return ((own - drivers.velocity) / options_.target_scale).transpose(0, 1);
  }

  /// Returns the mean squared error of the predicted noise over all present agents, at a random
  /// diffusion step for each. The higher weight of the attacker is our addition, because most other
  /// agents just continue.
  Tensor lossOn(const TrafficBatch& batch) {
    const int now = traffic().history_frames - 1;
    const TrafficBatch history = historyOf(batch, now + 1);
    const Tensor there = seenThroughout(history, now + 1);
    const Tensor known = there.unsqueeze(2) * batch.seen.slice(2, now, -1) *
                         batch.seen.slice(2, now + 1);  // [B, A, F]: both ends of a step are seen
    const Drivers drivers = driversOf(history, known.amax(2), there, options_);
    const Tensor counted = known.flatten(0, 1).index_select(0, drivers.rows);  // [N, F]
    const Tensor target = targetOf(batch, drivers) * counted.t().unsqueeze(2);
    const Tensor t = torch::randint(1, options_.diffusion_steps + 1, {drivers.rows.size(0)},
                                    torch::dtype(torch::kLong).device(device_));
    const auto atStep = [&](const std::vector<double>& schedule) {
      return torch::tensor(schedule, target.options()).index_select(0, t).unsqueeze(1);
    };
    const Tensor left = atStep(schedule_.alpha_bar);  // [N, 1]
    const Tensor noise = torch::randn_like(target);
    const Tensor noised = left.sqrt() * target + (1.0 - left).sqrt() * noise;
    const Tensor found = denoiser_->noiseIn(noised, atStep(schedule_.beta),
                                            denoiser_->contextOf(drivers), counted.eq(0.0));
    const Tensor attacks =
        drivers.rows.remainder(known.size(1)).eq(static_cast<long>(kAttackerAgent));
    const Tensor weights =
        counted * (1.0 + (options_.attacker_weight - 1.0) * attacks).unsqueeze(1);
    return ((found - noise).pow(2).mean(2) * weights.t()).sum() / weights.sum();
  }

  MidOptions options_;
  NoiseSchedule schedule_;
  torch::Device device_;
  std::shared_ptr<Denoiser> denoiser_;
  torch::optim::Adam optimizer_;
};

}  // namespace

NoiseSchedule noiseSchedule(const MidOptions& options) {
  NoiseSchedule schedule{{0.0}, {1.0}};
  for (int t = 0; t < options.diffusion_steps; ++t) {
    const double share = t / std::max(options.diffusion_steps - 1.0, 1.0);
    const double beta = options.beta_first + share * (options.beta_last - options.beta_first);
    schedule.beta.push_back(beta);
    schedule.alpha_bar.push_back(schedule.alpha_bar.back() * (1.0 - beta));
  }
  return schedule;
}

std::shared_ptr<TrafficGenerator> makeMid(const MidOptions& options, const TrafficOptions& traffic,
                                          torch::Device device) {
  return std::make_shared<Mid>(options, traffic, device);
}

}  // namespace forge
