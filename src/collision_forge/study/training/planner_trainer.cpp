#include "collision_forge/study/training/planner_trainer.h"

#include <torch/script.h>
#include <torch/torch.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <sstream>

#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/planner_test/planners/planner_contract.h"

namespace forge {
namespace {

constexpr double kWarmUp = 0.05;  // share of the steps with rising learning rate
constexpr std::size_t kErrorBatch = 1024;

// Scales of the inputs, which make them of order one.
constexpr float kEgoScales[] = {0.1f, 0.1f, 1.0f, 0.1f, 0.5f, 1.0f};
constexpr float kRouteScales[] = {0.02f, 0.1f, 1.0f};

/// The TorchScript of the planner: constant velocity plus the deviation predicted by the network.
constexpr const char* kScript = R"(
def drive(self, ego_history, route):
    seen = torch.cat([(ego_history * self.ego_scales).flatten(1), (route * self.route_scales).flatten(1)], 1)
    hidden = torch.relu(torch.addmm(self.bias_1, seen, self.weight_1))
    hidden = torch.relu(torch.addmm(self.bias_2, hidden, self.weight_2))
    terms = torch.addmm(self.bias_3, hidden, self.weight_3).view([-1, 3, self.powers.size(0)])
    added = torch.matmul(terms, self.powers)
    along = ego_history[:, -1, 3:4] * self.times.unsqueeze(0)
    return torch.stack([added[:, 0] + along, added[:, 1], added[:, 2]], 2)

def forward(self, ego_history, agents, agents_mask, lanes, lanes_mask, route):
    return self.drive(ego_history.unsqueeze(0), route.unsqueeze(0))[0]
)";

torch::Tensor vectorOf(const float* numbers, std::size_t count) {
  return torch::tensor(torch::ArrayRef<float>(numbers, count));
}

/// Returns the times of the poses, s.
torch::Tensor poseTimes() {
  return torch::arange(1, static_cast<long>(kContractPoses) + 1).to(torch::kFloat32) *
         kContractPoseStep;
}

void addLayer(torch::jit::Module& module, const std::string& number, long from, long to,
              double scale) {
  const torch::Tensor weight = torch::randn({from, to}) * scale / std::sqrt(double(from));
  module.register_parameter("weight_" + number, weight.set_requires_grad(true), false);
  module.register_parameter("bias_" + number, torch::zeros({to}).set_requires_grad(true), false);
}

/// Returns an untrained planner.
torch::jit::Module newPlanner(const PlannerTrainingOptions& options) {
  torch::jit::Module module("Planner");
  const torch::Tensor times = poseTimes();
  std::vector<torch::Tensor> powers;
  for (int term = 1; term <= options.terms; ++term) powers.push_back((times / times[-1]).pow(term));
  module.register_buffer("ego_scales", vectorOf(kEgoScales, std::size(kEgoScales)));
  module.register_buffer("route_scales", vectorOf(kRouteScales, std::size(kRouteScales)));
  module.register_buffer("times", times);
  module.register_buffer("powers", torch::stack(powers));
  const auto seen =
      static_cast<long>(kContractInputs[kEgoHistory].count() + kContractInputs[kRoute].count());
  addLayer(module, "1", seen, options.hidden, std::sqrt(2.0));
  addLayer(module, "2", options.hidden, options.hidden, std::sqrt(2.0));
  addLayer(module, "3", options.hidden, 3L * options.terms, 0.1);
  module.define(kScript);
  return module;
}

/// Samples as tensors, one row per sample.
struct PlannerBatch {
  torch::Tensor ego_history;  // [B, frames, numbers]
  torch::Tensor route;        // [B, points, 3]
  torch::Tensor poses;        // [B, poses, 3]
  torch::Tensor mask;         // [B, poses], 1 where a pose is known
};

PlannerBatch batchOf(const std::vector<PlannerSample>& samples, const std::size_t* chosen,
                     std::size_t count) {
  std::vector<torch::Tensor> histories, routes, poses, masks;
  for (std::size_t i = 0; i < count; ++i) {
    const PlannerSample& sample = samples[chosen[i]];
    histories.push_back(vectorOf(sample.ego_history.data(), sample.ego_history.size()));
    routes.push_back(vectorOf(sample.route.data(), sample.route.size()));
    poses.push_back(vectorOf(sample.poses.data(), sample.poses.size()));
    masks.push_back((torch::arange(long(kContractPoses)) < long(sample.known)).to(torch::kFloat32));
  }
  const auto rows = [](const std::vector<torch::Tensor>& parts, std::size_t numbers) {
    return torch::stack(parts).view({long(parts.size()), -1, long(numbers)});
  };
  return {rows(histories, kContractEgoNumbers), rows(routes, kContractPoseNumbers),
          rows(poses, kContractPoseNumbers), torch::stack(masks)};
}

/// Returns [rows, 1] with 1 at random in the given share of rows, else 0.
torch::Tensor drawn(long rows, double share) {
  return (torch::rand({rows, 1}) < share).to(torch::kFloat32);
}

/// Exchanges left and right (signs of y and yaw) in a random share of the rows.
void mirror(PlannerBatch& batch, double share) {
  const torch::Tensor sign = 1.0 - 2.0 * drawn(batch.mask.size(0), share).unsqueeze(2);
  for (torch::Tensor* tensor : {&batch.ego_history, &batch.route, &batch.poses}) {
    tensor->slice(2, 1, 3).mul_(sign);
  }
}

/// Removes, in a random share of the rows, the history before a random frame and the acceleration.
void hideHistory(PlannerBatch& batch, double share) {
  const long rows = batch.mask.size(0);
  const torch::Tensor frames = torch::arange(long(kContractFrames)).unsqueeze(0);
  const torch::Tensor first = torch::randint(1, long(kContractFrames), {rows, 1});
  const torch::Tensor hidden = drawn(rows, share);
  const torch::Tensor kept = 1.0 - hidden * (frames < first).to(torch::kFloat32);
  batch.ego_history.mul_(kept.unsqueeze(2));
  batch.ego_history.select(2, 4).mul_(1.0 - hidden);
}

/// Transforms poses to the frame of an ego that is displaced by `left` m and turned by `turned` rad
/// ([B, 1] each).
void seenFrom(torch::Tensor& poses, const torch::Tensor& left, const torch::Tensor& turned) {
  const torch::Tensor x = poses.select(2, 0).clone();
  const torch::Tensor y = poses.select(2, 1) - left;
  const torch::Tensor yaw = poses.select(2, 2) - turned;
  const torch::Tensor cosine = torch::cos(turned);
  const torch::Tensor sine = torch::sin(turned);
  poses = torch::stack({cosine * x + sine * y, cosine * y - sine * x, yaw}, 2);
}

/// Displaces the ego in a random share of the rows; the target then returns to the recorded path.
void moveEgo(PlannerBatch& batch, const PlannerTrainingOptions& options) {
  const long rows = batch.mask.size(0);
  const torch::Tensor moved = drawn(rows, options.moved_share);
  const torch::Tensor left = moved * torch::randn({rows, 1}) * options.lateral_noise;
  const torch::Tensor turned = moved * torch::randn({rows, 1}) * options.heading_noise;
  const torch::Tensor fading = torch::exp(-poseTimes() / options.return_time).unsqueeze(0);
  batch.poses.select(2, 1).add_(left * fading);
  batch.poses.select(2, 2).add_(turned * fading);
  seenFrom(batch.poses, left, turned);
  seenFrom(batch.route, left, turned);
}

/// Returns the mean absolute error over the known poses.
torch::Tensor lossOf(const torch::Tensor& planned, const PlannerBatch& batch,
                     double heading_weight) {
  const torch::Tensor error = (planned - batch.poses).abs();
  const torch::Tensor each =
      error.select(2, 0) + error.select(2, 1) + heading_weight * error.select(2, 2);
  return (each * batch.mask).sum() / batch.mask.sum();
}

/// Accumulates displacement errors.
struct ErrorSums {
  std::array<double, DisplacementErrors::kTimes.size()> sums{};
  std::array<std::size_t, DisplacementErrors::kTimes.size()> counts{};

  void add(const torch::Tensor& planned, const PlannerBatch& batch) {
    const torch::Tensor difference = (planned - batch.poses).slice(2, 0, 2);
    const torch::Tensor distance = difference.pow(2).sum(2).sqrt();
    for (std::size_t i = 0; i < sums.size(); ++i) {
      const long poses = std::lround(DisplacementErrors::kTimes[i] / kContractPoseStep);
      const torch::Tensor lasts = batch.mask.select(1, poses - 1);
      sums[i] += (distance.slice(1, 0, poses).mean(1) * lasts).sum().item<double>();
      counts[i] += static_cast<std::size_t>(lasts.sum().item<double>());
    }
  }

  DisplacementErrors means() const {
    DisplacementErrors errors;
    errors.moments = counts;
    for (std::size_t i = 0; i < sums.size(); ++i) {
      if (counts[i] > 0) errors.means[i] = sums[i] / static_cast<double>(counts[i]);
    }
    return errors;
  }
};

/// Returns the errors of `plan`, which maps a batch to poses [B, poses, 3].
template <typename Plan>
DisplacementErrors errorsOf(const std::vector<PlannerSample>& samples,
                            const std::vector<std::size_t>& chosen, const Plan& plan) {
  const torch::NoGradGuard no_gradients;
  ErrorSums sums;
  for (std::size_t start = 0; start < chosen.size(); start += kErrorBatch) {
    const std::size_t count = std::min(kErrorBatch, chosen.size() - start);
    const PlannerBatch batch = batchOf(samples, chosen.data() + start, count);
    sums.add(plan(batch), batch);
  }
  return sums.means();
}

}  // namespace

DisplacementErrors constantVelocityErrors(const std::vector<PlannerSample>& samples,
                                          const std::vector<std::size_t>& chosen) {
  return errorsOf(samples, chosen, [](const PlannerBatch& batch) {
    const torch::Tensor speed = batch.ego_history.select(1, -1).slice(1, 3, 4);
    const torch::Tensor along = speed * poseTimes().unsqueeze(0);
    return torch::stack({along, torch::zeros_like(along), torch::zeros_like(along)}, 2);
  });
}

struct PlannerTrainer::State {
  PlannerTrainingOptions options;
  std::mt19937_64 engine;
  torch::jit::Module module{"Planner"};
  std::vector<torch::Tensor> parameters;
  std::unique_ptr<torch::optim::AdamW> optimizer;
  long steps = 0;

  torch::Tensor plan(const PlannerBatch& batch) {
    return module.get_method("drive")({batch.ego_history, batch.route}).toTensor();
  }

  /// Sets the learning rate: linear warm-up, then cosine decay.
  void setRate(long all_steps) {
    const double share = static_cast<double>(steps) / static_cast<double>(all_steps);
    const double rate = share < kWarmUp
                            ? share / kWarmUp
                            : 0.5 * (1.0 + std::cos(M_PI * (share - kWarmUp) / (1.0 - kWarmUp)));
    for (auto& group : optimizer->param_groups()) {
      static_cast<torch::optim::AdamWOptions&>(group.options()).lr(rate * options.learning_rate);
    }
  }

  double step(PlannerBatch batch) {
    mirror(batch, options.mirrored_share);
    hideHistory(batch, options.hidden_history_share);
    moveEgo(batch, options);
    optimizer->zero_grad();
    const torch::Tensor loss = lossOf(plan(batch), batch, options.heading_weight);
    loss.backward();
    torch::nn::utils::clip_grad_norm_(parameters, options.max_gradient);
    optimizer->step();
    ++steps;
    return loss.item<double>();
  }
};

PlannerTrainer::PlannerTrainer(const PlannerTrainingOptions& options, int threads,
                               std::uint64_t seed)
    : state_(std::make_unique<State>()) {
  torch::set_num_threads(threads);
  torch::manual_seed(seed);
  torch::jit::setGraphExecutorOptimize(false);
  state_->options = options;
  state_->engine.seed(seed);
  state_->module = newPlanner(options);
  for (const torch::Tensor& parameter : state_->module.parameters()) {
    state_->parameters.push_back(parameter);
  }
  state_->optimizer = std::make_unique<torch::optim::AdamW>(
      state_->parameters,
      torch::optim::AdamWOptions(options.learning_rate).weight_decay(options.weight_decay));
}

PlannerTrainer::~PlannerTrainer() = default;

double PlannerTrainer::trainEpoch(const std::vector<PlannerSample>& samples,
                                  const std::vector<std::size_t>& chosen) {
  std::vector<std::size_t> order = chosen;
  for (std::size_t i = order.size(); i > 1; --i) {
    std::swap(order[i - 1], order[state_->engine() % i]);
  }
  const auto batch = static_cast<std::size_t>(state_->options.batch);
  const auto steps = static_cast<long>((order.size() + batch - 1) / batch);
  double sum = 0.0;
  for (std::size_t start = 0; start < order.size(); start += batch) {
    state_->setRate(steps * state_->options.epochs);
    const std::size_t count = std::min(batch, order.size() - start);
    sum += state_->step(batchOf(samples, order.data() + start, count)) * double(count);
  }
  return sum / static_cast<double>(order.size());
}

DisplacementErrors PlannerTrainer::errors(const std::vector<PlannerSample>& samples,
                                          const std::vector<std::size_t>& chosen) {
  return errorsOf(samples, chosen,
                  [this](const PlannerBatch& batch) { return state_->plan(batch); });
}

void PlannerTrainer::save(const std::string& path,
                          const std::vector<std::string>& left_out_scenes) {
  torch::jit::ExtraFilesMap extra;
  std::string& names = extra["left_out_scenes"];
  for (const std::string& name : left_out_scenes) names += name + '\n';
  torch::jit::Module module = state_->module.deepcopy();
  for (torch::Tensor parameter : module.parameters()) parameter.set_requires_grad(false);
  std::ostringstream bytes;  // writing a module to a file directly aborts on errors
  module.save(bytes, extra);
  writeText(path, bytes.str());
}

}  // namespace forge
