#include "collision_forge/study/generators/social_gan.h"

#include <cmath>
#include <limits>

namespace forge {
namespace {

using torch::Tensor;
namespace nn = torch::nn;

// Ranges of the labels for the discriminator, drawn anew for each batch (Social-GAN's code).
constexpr double kRealLabel[] = {0.7, 1.2};
constexpr double kFakeLabel[] = {0.0, 0.3};

/// Returns a linear layer with Kaiming initialisation, as in Social-GAN's code.
nn::Linear linear(long from, long to) {
  nn::Linear layer(from, to);
  nn::init::kaiming_normal_(layer->weight);
  return layer;
}

nn::LSTM recurrent(long from, long to) {
  return nn::LSTM(nn::LSTMOptions(from, to).batch_first(true));
}

/// Returns the steps between successive frames [B, A, T, 2] in units of `scale` (m); the first is
/// 0.
Tensor stepsOf(const Tensor& poses, double scale) {
  const Tensor places = poses.slice(3, 0, 2);
  const Tensor first = torch::zeros_like(places.slice(2, 0, 1));
  return torch::cat({first, places.diff(1, 2)}, 2) / scale;
}

/// Returns the last output of an LSTM over each agent's steps: [B, A, T, 2] to [B, A, H].
Tensor lastOutput(nn::Linear& embedding, nn::LSTM& net, const Tensor& steps) {
  const Tensor flat = embedding(steps).flatten(0, 1);
  const Tensor last = std::get<0>(net(flat)).select(1, flat.size(1) - 1);
  return last.view({steps.size(0), steps.size(1), -1});
}

/// The paper's generator: encoder, pooling, context, decoder.
struct Driver : nn::Module {
  Driver(const SocialGanOptions& options, long future_frames)
      : options(options), future_frames(future_frames) {
    const long context = options.decoder - options.noise;
    encoder_embedding = register_module("encoder_embedding", linear(2, options.embedding));
    encoder = register_module("encoder", recurrent(options.embedding, options.encoder));
    pool_embedding = register_module("pool_embedding", linear(2, options.embedding));
    pool_1 = register_module("pool_1",
                             linear(options.embedding + options.encoder, options.pooling_layer));
    pool_2 = register_module("pool_2", linear(options.pooling_layer, options.pooled));
    context_1 = register_module("context_1",
                                linear(options.encoder + options.pooled, options.context_layer));
    context_2 = register_module("context_2", linear(options.context_layer, context));
    decoder_embedding = register_module("decoder_embedding", linear(2, options.embedding));
    decoder = register_module("decoder",
                              nn::LSTMCell(options.embedding + kConditionNumbers, options.decoder));
    output = register_module("output", linear(options.decoder, 2));
  }

  /// Returns the pooled feature [B, A, P]: the maximum over all agents, as seen from each agent.
  Tensor pooled(const Tensor& hidden, const Tensor& places, const Tensor& there) {
    const Tensor relative = places.unsqueeze(1) - places.unsqueeze(2);               // [B, i, j, 2]
    const Tensor others = hidden.unsqueeze(1).expand({-1, hidden.size(1), -1, -1});  // [B, i, j, H]
    const Tensor seen = torch::cat({pool_embedding(relative), others}, 3);
    const Tensor judged = torch::relu(pool_2(torch::relu(pool_1(seen))));
    return (judged * there.unsqueeze(1).unsqueeze(3)).amax(2);  // ReLU is never below 0
  }

  /// Returns the context [B, A, decoder - noise], computed once for all samples.
  Tensor contextOf(const TrafficBatch& history) {
    const Tensor hidden =
        lastOutput(encoder_embedding, encoder, stepsOf(history.poses, options.step_scale));
    const Tensor places =
        history.poses.select(2, history.poses.size(2) - 1).slice(2, 0, 2) / options.position_scale;
    const Tensor there = seenThroughout(history, static_cast<int>(history.poses.size(2)));
    const Tensor all = torch::cat({hidden, pooled(hidden, places, there)}, 2);
    return torch::relu(context_2(torch::relu(context_1(all))));
  }

  /// Predicts the next steps [B, A, F, 2] in units of step_scale; `noise` [B, noise] is shared by
  /// all agents of a scene.
  Tensor decode(const Tensor& context, Tensor step, const Tensor& condition, const Tensor& noise) {
    const long agents = context.size(1);
    const auto ofEach = [&](const Tensor& of_scene) {
      return of_scene.unsqueeze(1).expand({-1, agents, -1}).flatten(0, 1);
    };
    Tensor hidden = torch::cat({context.flatten(0, 1), ofEach(noise)}, 1);
    Tensor cell = torch::zeros_like(hidden);
    const Tensor asked = ofEach(condition);
    step = step.flatten(0, 1);
    std::vector<Tensor> steps;
    for (long t = 0; t < future_frames; ++t) {
      const Tensor input = torch::cat({decoder_embedding(step), asked}, 1);
      std::tie(hidden, cell) = decoder(input, std::make_tuple(hidden, cell));
      step = output(hidden);
      steps.push_back(step);
    }
    return torch::stack(steps, 1).view({-1, agents, future_frames, 2});
  }

  SocialGanOptions options;
  long future_frames;
  nn::Linear encoder_embedding{nullptr}, pool_embedding{nullptr}, pool_1{nullptr}, pool_2{nullptr};
  nn::Linear context_1{nullptr}, context_2{nullptr}, decoder_embedding{nullptr}, output{nullptr};
  nn::LSTM encoder{nullptr};
  nn::LSTMCell decoder{nullptr};
};

/// The paper's discriminator: scores whether a path of twelve frames is recorded.
struct Judge : nn::Module {
  explicit Judge(const SocialGanOptions& options) {
    embedding = register_module("embedding", linear(2, options.embedding));
    encoder = register_module("encoder", recurrent(options.embedding, options.discriminator));
    score_1 = register_module("score_1", linear(options.discriminator, options.discriminator));
    score_2 = register_module("score_2", linear(options.discriminator, 1));
  }

  /// Returns the scores [B, A]. Omits the final ReLU of Social-GAN's code, whose gradient vanishes
  /// once all scores are 0.
  Tensor forward(const Tensor& steps) {
    const Tensor hidden = torch::relu(score_1(lastOutput(embedding, encoder, steps)));
    return score_2(hidden).squeeze(2);
  }

  nn::Linear embedding{nullptr}, score_1{nullptr}, score_2{nullptr};
  nn::LSTM encoder{nullptr};
};

class SocialGan : public TrafficGenerator {
 public:
  SocialGan(const SocialGanOptions& options, const TrafficOptions& traffic, torch::Device device)
      : TrafficGenerator(traffic),
        options_(options),
        device_(device),
        driver_(std::make_shared<Driver>(options, traffic.future_frames)),
        judge_(std::make_shared<Judge>(options)),
        driver_steps_(driver_->parameters(), torch::optim::AdamOptions(options.learning_rate)),
        judge_steps_(judge_->parameters(), torch::optim::AdamOptions(options.learning_rate)) {
    driver_->to(device);
    judge_->to(device);
  }

  Tensor predict(const TrafficBatch& history, torch::Generator noise) const override {
    const long now = history.poses.size(2) - 1;
    const Tensor drawn = torch::randn({history.poses.size(0), options_.noise}, noise).to(device_);
    const Tensor steps =
        options_.step_scale *
        driver_->decode(driver_->contextOf(history), lastStep(history), history.condition, drawn);
    const Tensor pose = history.poses.select(2, now);
    const Tensor places = pose.slice(2, 0, 2).unsqueeze(2) + steps.cumsum(2);
    const Tensor yaws = yawsAlong(steps, pose.select(2, 2), traffic().min_step);
    return torch::cat({places, yaws.unsqueeze(3)}, 3);
  }

  std::vector<std::string> lossNames() const override {
    return {"variety", "adversarial", "discriminator"};
  }

  std::vector<double> trainStep(const TrafficBatch& batch) override {
    const double none = std::numeric_limits<double>::quiet_NaN();
    if (steps_++ % (options_.discriminator_steps + 1) < options_.discriminator_steps) {
      return {none, none, trainJudge(batch)};
    }
    const auto [variety, adversarial] = trainDriver(batch);
    return {variety, adversarial, none};
  }

  int epochs() const override { return options_.epochs; }
  int batchSize() const override { return options_.batch; }
  std::shared_ptr<nn::Module> network() const override { return driver_; }

  void saveTraining(torch::serialize::OutputArchive& archive) const override {
    torch::serialize::OutputArchive judge, judge_steps, driver_steps;
    judge_->save(judge);
    judge_steps_.save(judge_steps);
    driver_steps_.save(driver_steps);
    archive.write("judge", judge);
    archive.write("judge_steps", judge_steps);
    archive.write("driver_steps", driver_steps);
    archive.write("steps", torch::tensor(steps_));
  }

  void loadTraining(torch::serialize::InputArchive& archive) override {
    torch::serialize::InputArchive judge, judge_steps, driver_steps;
    Tensor steps;
    archive.read("judge", judge);
    archive.read("judge_steps", judge_steps);
    archive.read("driver_steps", driver_steps);
    archive.read("steps", steps);
    judge_->load(judge);
    judge_steps_.load(judge_steps);
    driver_steps_.load(driver_steps);
    steps_ = steps.item<std::int64_t>();
  }

 private:
  Tensor lastStep(const TrafficBatch& history) const {
    const Tensor steps = stepsOf(history.poses, options_.step_scale);
    return steps.select(2, steps.size(2) - 1);
  }

  Tensor drawNoise(long scenes) const {
    return torch::randn({scenes, options_.noise}, torch::device(device_));
  }

  /// Returns a label for all scores [B, A], drawn from the range once per batch.
  static Tensor labels(const Tensor& scores, const double (&range)[2]) {
    const double drawn = torch::rand({1}).item<double>();
    return torch::full_like(scores, range[0] + (range[1] - range[0]) * drawn);
  }

  /// Returns the cross entropy over the agents set in `there`.
  static Tensor judged(const Tensor& scores, const double (&range)[2], const Tensor& there) {
    return torch::binary_cross_entropy_with_logits(scores, labels(scores, range), there, {},
                                                   torch::Reduction::Sum) /
           there.sum().clamp_min(1.0);
  }

  TrafficBatch historyIn(const TrafficBatch& batch) const {
    return historyOf(batch, traffic().history_frames);
  }

  /// Joins the history and the predicted steps for the discriminator.
  Tensor fullMotion(const TrafficBatch& history, const Tensor& driven) const {
    return torch::cat({stepsOf(history.poses, options_.step_scale), driven}, 2);
  }

  double trainJudge(const TrafficBatch& batch) {
    const TrafficBatch history = historyIn(batch);
    const Tensor there = seenThroughout(batch, static_cast<int>(batch.poses.size(2)));
    Tensor driven;
    {
      const torch::NoGradGuard no_gradients;
      driven = driver_->decode(driver_->contextOf(history), lastStep(history), batch.condition,
                               drawNoise(batch.poses.size(0)));
    }
    judge_steps_.zero_grad();
    const Tensor loss =
        judged(judge_->forward(stepsOf(batch.poses, options_.step_scale)), kRealLabel, there) +
        judged(judge_->forward(fullMotion(history, driven)), kFakeLabel, there);
    loss.backward();
    judge_steps_.step();
    return loss.item<double>();
  }

  /// Trains one step of the generator. Returns the variety loss and the adversarial loss.
  std::pair<double, double> trainDriver(const TrafficBatch& batch) {
    const TrafficBatch history = historyIn(batch);
    const long scenes = batch.poses.size(0);
    const Tensor known =  // [B, A, F]: both ends of the step and the whole history are observed
        seenThroughout(history, traffic().history_frames).unsqueeze(2) *
        batch.seen.slice(2, traffic().history_frames - 1, -1) *
        batch.seen.slice(2, traffic().history_frames);
    const Tensor recorded =
        stepsOf(batch.poses, options_.step_scale).slice(2, traffic().history_frames);
    const Tensor there = seenThroughout(batch, static_cast<int>(batch.poses.size(2)));
    driver_steps_.zero_grad();
    const Tensor context = driver_->contextOf(history);
    std::vector<Tensor> errors;
    Tensor driven;
    for (int sample = 0; sample < options_.variety; ++sample) {
      driven = driver_->decode(context, lastStep(history), batch.condition, drawNoise(scenes));
      errors.push_back(((driven - recorded).pow(2).sum(3) * known).sum({1, 2}));
    }
    const Tensor best = torch::stack(errors).amin(0);
    const Tensor variety = (best / known.sum({1, 2}).clamp_min(1.0)).sum();
    const Tensor adversarial =
        judged(judge_->forward(fullMotion(history, driven)), kRealLabel, there);
    (variety + adversarial).backward();
    nn::utils::clip_grad_norm_(driver_->parameters(), options_.max_gradient);
    driver_steps_.step();
    return {variety.item<double>() / static_cast<double>(scenes), adversarial.item<double>()};
  }

  SocialGanOptions options_;
  torch::Device device_;
  std::shared_ptr<Driver> driver_;
  std::shared_ptr<Judge> judge_;
  torch::optim::Adam driver_steps_;
  torch::optim::Adam judge_steps_;
  std::int64_t steps_ = 0;
};

}  // namespace

std::shared_ptr<TrafficGenerator> makeSocialGan(const SocialGanOptions& options,
                                                const TrafficOptions& traffic,
                                                torch::Device device) {
  return std::make_shared<SocialGan>(options, traffic, device);
}

}  // namespace forge
