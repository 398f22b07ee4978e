#include "collision_forge/study/generators/strive_network.h"

#include <cmath>

namespace forge {

using torch::Tensor;
namespace nn = torch::nn;

/// The paper's MLP: linear layers with LayerNorm and ReLU in between.
struct StriveMlp : nn::Module {
  explicit StriveMlp(const std::vector<long>& sizes) {
    for (std::size_t i = 0; i + 1 < sizes.size(); ++i) {
      if (i > 0) {
        layers->push_back(nn::LayerNorm(nn::LayerNormOptions({sizes[i]})));
        layers->push_back(nn::ReLU());
      }
      layers->push_back(nn::Linear(sizes[i], sizes[i + 1]));
    }
    register_module("layers", layers);
  }

  Tensor operator()(const Tensor& input) { return layers->forward(input); }

  nn::Sequential layers;
};

namespace {

constexpr double kMostTurn = 2.0 * M_PI;    // rad/s (STRIVE's code)
constexpr double kMostSpeed = 50.0;         // m/s (STRIVE's code)
constexpr double kLeastTurningSpeed = 2.0;  // m/s; below it recorded yaw rates are noise
constexpr int kDiscs = 5;                   // along a box (STRIVE, supplement)
constexpr double kFar = 1e6;                // m, distance of missing lane points

/// Returns poses relative to `origin` [..., 3]: x, y in units of `scale` (m), cos and sin of the
/// yaw.
Tensor seenFrom(const Tensor& origin, const Tensor& poses, double scale) {
  const Tensor cos = origin.select(-1, 2).cos();
  const Tensor sin = origin.select(-1, 2).sin();
  const Tensor dx = poses.select(-1, 0) - origin.select(-1, 0);
  const Tensor dy = poses.select(-1, 1) - origin.select(-1, 1);
  const Tensor turn = poses.select(-1, 2) - origin.select(-1, 2);
  return torch::stack(
      {(cos * dx + sin * dy) / scale, (cos * dy - sin * dx) / scale, turn.cos(), turn.sin()}, -1);
}

/// Normalises angles to (-pi, pi].
Tensor wrapped(const Tensor& angles) { return torch::atan2(angles.sin(), angles.cos()); }

/// Selects the rows of the scene's agents from [B, A, ...].
Tensor rowsOf(const Tensor& numbers, const StriveScene& scene) {
  return numbers.index({scene.window, scene.agent});
}

/// The state of a kinematic bicycle in a frame.
struct Bicycle {
  Tensor pose;   ///< [N, 3]
  Tensor speed;  ///< [N] m/s
  Tensor turn;   ///< [N] rad/s

  /// Returns the state after one frame (the paper's model, with heading and speed at its end).
  Bicycle driven(const Tensor& acceleration, const Tensor& turn_change, double length) const {
    const Tensor next_turn = (turn + turn_change * kFrameInterval).clamp(-kMostTurn, kMostTurn);
    const Tensor yaw = pose.select(1, 2) + kFrameInterval / length * speed.abs() * next_turn;
    const Tensor next_speed = (speed + acceleration * kFrameInterval).clamp(0.0, kMostSpeed);
    const Tensor x = pose.select(1, 0) + kFrameInterval * next_speed * yaw.cos();
    const Tensor y = pose.select(1, 1) + kFrameInterval * next_speed * yaw.sin();
    return {torch::stack({x, y, yaw}, 1), next_speed, next_turn};
  }
};

}  // namespace

/// The paper's graph network: one round of messages over all pairs with maximum aggregation. The
/// first layer of a message is a sum over the two agents and their relative pose, so the agents'
/// parts are computed once per agent instead of once per pair.
struct StriveGraphNet : nn::Module {
  StriveGraphNet(long input, long hidden, long message, long output, double scale)
      : message_size(message), scale(scale) {
    const auto part = [&](const char* name, long size, bool bias) {
      return register_module(name, nn::Linear(nn::LinearOptions(size, hidden).bias(bias)));
    };
    const auto mlp = [&](const char* name, const std::vector<long>& sizes) {
      return register_module(name, std::make_shared<StriveMlp>(sizes));
    };
    of_one = part("of_one", input, true);
    of_other = part("of_other", input, false);
    of_way = part("of_way", 4, false);
    norm = register_module("norm", nn::LayerNorm(nn::LayerNormOptions({hidden})));
    tell = mlp("tell", {hidden, hidden, message});
    hear = mlp("hear", {input + message, hidden, message});
    say = mlp("say", {message, hidden, hidden, output});
  }

  /// Returns the messages [E, message].
  Tensor messages(const StriveScene& scene, const Tensor& nodes, const Tensor& poses) {
    const Tensor way =
        seenFrom(poses.index_select(0, scene.to), poses.index_select(0, scene.from), scale);
    const Tensor first = of_one(nodes).index_select(0, scene.to) +
                         of_other(nodes).index_select(0, scene.from) + of_way(way);
    return (*tell)(torch::relu(norm(first)));
  }

  /// Returns the maximum [N, message] over the messages to each agent; 0 without any.
  static Tensor largestOf(const Tensor& messages, const StriveScene& scene) {
    const long agents = scene.window.size(0);
    const long most = scene.place.max().item<long>() + 1;
    const Tensor nothing =
        torch::full({agents * most, messages.size(1)}, -kFar, messages.options());
    const Tensor largest = nothing.index_copy(0, scene.to * most + scene.place, messages)
                               .view({agents, most, -1})
                               .amax(1);
    return torch::where(largest > -kFar, largest, torch::zeros_like(largest));
  }

  Tensor forward(const StriveScene& scene, const Tensor& nodes, const Tensor& poses) {
    const Tensor heard = scene.to.size(0) > 0
                             ? largestOf(messages(scene, nodes, poses), scene)
                             : torch::zeros({nodes.size(0), message_size}, nodes.options());
    return (*say)((*hear)(torch::cat({nodes, heard}, 1)));
  }

  long message_size;
  double scale;
  nn::Linear of_one{nullptr}, of_other{nullptr}, of_way{nullptr};
  nn::LayerNorm norm{nullptr};
  std::shared_ptr<StriveMlp> tell, hear, say;
};

StriveNetwork::StriveNetwork(const StriveOptions& options, const TrafficOptions& traffic)
    : options_(options), traffic_(traffic) {
  const long hidden = options.hidden;
  const long feature = options.feature;
  const long latent = options.latent;
  const auto mlp = [&](const char* name, const std::vector<long>& sizes) {
    return register_module(name, std::make_shared<StriveMlp>(sizes));
  };
  const auto graph = [&](const char* name, long input, long message, long output) {
    return register_module(name, std::make_shared<StriveGraphNet>(input, hidden, message, output,
                                                                  options.position_scale));
  };
  past_ = mlp("past", {6L * traffic.history_frames, hidden, hidden, feature});
  future_ = mlp("future", {7L * traffic.future_frames, hidden, hidden, feature});
  lane_point_ = mlp("lane_point", {kLaneNumbers, options.lane_hidden, options.lane_hidden});
  lane_ = mlp("lane", {options.lane_hidden, options.lane_hidden, feature});
  prior_ = graph("prior", 2 * feature, hidden, 2 * latent);
  posterior_ = graph("posterior", 3 * feature, hidden, 2 * latent);
  decoder_ = graph("decoder", 2 * feature + latent + kConditionNumbers, feature, 2);
  memory_ = register_module("memory", nn::GRU(nn::GRUOptions(4, feature).num_layers(3)));
}

StriveNetwork::~StriveNetwork() = default;

/// Returns [N, T * 6]: poses relative to `origin` [N, 3], speeds and turns, scaled.
Tensor StriveNetwork::motionFeature(const Tensor& poses, const Tensor& origin) {
  const Tensor seen = seenFrom(origin.unsqueeze(1), poses, options_.position_scale);
  const Tensor steps = poses.slice(2, 0, 2).diff(1, 1) / kFrameInterval;
  const Tensor yaw = poses.select(2, 2).slice(1, 1);
  const Tensor speeds = steps.select(2, 0) * yaw.cos() + steps.select(2, 1) * yaw.sin();
  const Tensor rates = wrapped(poses.select(2, 2).diff(1, 1)) / kFrameInterval;
  const Tensor turns = rates * options_.length / speeds.clamp_min(kLeastTurningSpeed);
  const auto fromTheFirst = [](const Tensor& numbers) {
    return torch::cat({numbers.slice(1, 0, 1), numbers}, 1).unsqueeze(2);
  };
  return torch::cat({seen, (fromTheFirst(speeds) - options_.speed_mean) / options_.speed_scale,
                     fromTheFirst(turns) / options_.turn_scale},
                    2);
}

StriveScene StriveNetwork::encode(const TrafficBatch& history) {
  const long now = traffic_.history_frames - 1;
  StriveScene scene;
  const Tensor there = seenThroughout(history, traffic_.history_frames);
  const Tensor agents = there.nonzero();
  scene.window = agents.select(1, 0);
  scene.agent = agents.select(1, 1);
  const Tensor together = scene.window.unsqueeze(1) == scene.window.unsqueeze(0);
  const Tensor pairs = together.triu(1).logical_or(together.tril(-1)).nonzero();
  scene.to = pairs.select(1, 0);
  scene.from = pairs.select(1, 1);
  const Tensor before = together.tril(-1).sum(1);  // number of earlier agents of the window
  scene.place = before.index_select(0, scene.from);
  const Tensor poses = rowsOf(history.poses, scene);
  scene.pose = poses.select(1, now);
  scene.condition = history.condition.index_select(0, scene.window);
  const Tensor motion = motionFeature(poses, scene.pose);
  const Tensor last = motion.select(1, now);
  scene.speed =
      (last.select(1, 4) * options_.speed_scale + options_.speed_mean).clamp(0.0, kMostSpeed);
  scene.turn = (last.select(1, 5) * options_.turn_scale).clamp(-kMostTurn, kMostTurn);
  Tensor shown = motion;
  if (is_training()) shown = shown + options_.noise * torch::randn_like(shown);
  scene.past = (*past_)(shown.flatten(1));
  scene.map = mapFeature(history, scene);
  return scene;
}

/// Encodes the lane pieces nearest to a point ahead of each agent, in the agent's frame.
Tensor StriveNetwork::mapFeature(const TrafficBatch& history, const StriveScene& scene) {
  const long count = std::min<long>(history.lanes.size(1), options_.lanes_of_agent);
  if (count == 0) return torch::zeros_like(scene.past);
  const Tensor lanes = history.lanes.index_select(0, scene.window);      // [N, L, P, 5]
  const Tensor known = history.lane_seen.index_select(0, scene.window);  // [N, L, P]
  const Tensor yaw = scene.pose.select(1, 2);
  const Tensor ahead =
      scene.pose.slice(1, 0, 2) + options_.map_ahead * torch::stack({yaw.cos(), yaw.sin()}, 1);
  const Tensor apart = (lanes.slice(3, 0, 2) - ahead.unsqueeze(1).unsqueeze(1)).norm(2, 3);
  const Tensor far = (apart + (1.0 - known) * kFar).amin(2);
  const Tensor nearest = std::get<1>(far.topk(count, 1, false));  // [N, K]
  const auto chosen = [&](const Tensor& of_lanes) {
    std::vector<long> shape(static_cast<std::size_t>(of_lanes.dim()), 1);
    shape[0] = nearest.size(0);
    shape[1] = count;
    auto sizes = of_lanes.sizes().vec();
    sizes[1] = count;
    return of_lanes.gather(1, nearest.view(shape).expand(sizes));
  };
  const Tensor points = chosen(lanes);
  const Tensor there = chosen(known).unsqueeze(3);  // [N, K, P, 1]
  const Tensor poses = torch::cat(
      {points.slice(3, 0, 2), torch::atan2(points.select(3, 3), points.select(3, 2)).unsqueeze(3)},
      3);
  const Tensor seen =
      seenFrom(scene.pose.unsqueeze(1).unsqueeze(1), poses, options_.position_scale);
  const Tensor inner = torch::relu((*lane_point_)(torch::cat({seen, points.slice(3, 4)}, 3)));
  return (*lane_)((inner * there).amax(2)).amax(1);
}

static StriveLatent latentOf(const Tensor& output) {
  const std::vector<Tensor> halves = output.chunk(2, 1);
  return {halves[0], halves[1]};
}

StriveLatent StriveNetwork::prior(const StriveScene& scene) {
  return latentOf(prior_->forward(scene, torch::cat({scene.past, scene.map}, 1), scene.pose));
}

StriveLatent StriveNetwork::posterior(const StriveScene& scene, const TrafficBatch& future) {
  const Tensor poses = rowsOf(future.poses, scene).slice(1, traffic_.history_frames - 1);
  const Tensor seen = rowsOf(future.seen, scene).slice(1, traffic_.history_frames).unsqueeze(2);
  const Tensor motion = motionFeature(poses, scene.pose).slice(1, 1);
  const Tensor came = (*future_)(torch::cat({motion * seen, seen}, 2).flatten(1));
  return latentOf(
      posterior_->forward(scene, torch::cat({scene.past, scene.map, came}, 1), scene.pose));
}

Tensor StriveNetwork::drive(const StriveScene& scene, const Tensor& latent, long frames) {
  Bicycle bicycle{scene.pose, scene.speed, scene.turn};
  Tensor past = scene.past;
  Tensor memory = past.unsqueeze(0).repeat({3, 1, 1});
  std::vector<Tensor> poses;
  for (long frame = 0; frame < frames; ++frame) {
    const Tensor nodes = torch::cat({past, scene.map, latent, scene.condition}, 1);
    const Tensor asked = decoder_->forward(scene, nodes, bicycle.pose);
    const Tensor before = bicycle.pose;
    bicycle = bicycle.driven(options_.acceleration_scale * asked.select(1, 0),
                             options_.turn_change_scale * asked.select(1, 1), options_.length);
    poses.push_back(bicycle.pose);
    const Tensor step = seenFrom(before, bicycle.pose, options_.position_scale);
    Tensor heard;
    std::tie(heard, memory) = memory_->forward(step.unsqueeze(0), memory);
    past = heard.squeeze(0);
  }
  return torch::stack(poses, 1);
}

Tensor overlapOf(const StriveScene& scene, const Tensor& poses, const StriveOptions& options) {
  const double radius = 0.5 * options.width;
  const double outermost = 0.5 * options.length - radius;
  const Tensor along = torch::linspace(-outermost, outermost, kDiscs, poses.options());
  const Tensor yaw = poses.select(2, 2).unsqueeze(2);
  const Tensor discs = torch::stack({poses.select(2, 0).unsqueeze(2) + along * yaw.cos(),
                                     poses.select(2, 1).unsqueeze(2) + along * yaw.sin()},
                                    3);  // [N, F, 5, 2]
  const Tensor of_one = discs.index_select(0, scene.to).unsqueeze(3);
  const Tensor of_other = discs.index_select(0, scene.from).unsqueeze(2);
  const Tensor square = (of_one - of_other).pow(2).sum(4).amin({2, 3});
  return torch::relu(1.0 - (square + 1e-6).sqrt() / (2.0 * radius));
}

Tensor beyondLanes(const Tensor& window, const TrafficBatch& batch, const Tensor& poses,
                   double reach) {
  if (batch.lanes.size(1) == 0) return torch::zeros_like(poses.select(2, 0));
  const Tensor points =
      (batch.lanes.slice(3, 0, 2) + kFar * (1.0 - batch.lane_seen).unsqueeze(3)).flatten(1, 2);
  const Tensor places = poses.slice(2, 0, 2);
  const Tensor square =
      (places.unsqueeze(2) - points.index_select(0, window).unsqueeze(1)).pow(2).sum(3).amin(2);
  const Tensor known = (square < 0.25 * kFar * kFar).to(square.options());
  return known * torch::relu((square + 1e-6).sqrt() - reach);
}

}  // namespace forge
