#include "collision_forge/study/training/pattern_trainer.h"

#include <torch/torch.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <random>
#include <sstream>
#include <utility>

#include "collision_forge/base/files/fingerprint.h"
#include "collision_forge/study/training/pattern_module.h"
#include "collision_forge/study/training/training_device.h"

namespace forge {
namespace {

constexpr double kAverageDecay = 0.998;  // decay per step of the averaged weights
constexpr double kWarmUp = 0.05;         // share of the steps with rising learning rate
constexpr std::size_t kLossBatch = 128;

RowMatrix toMatrix(const torch::Tensor& tensor) {
  const torch::Tensor flat = tensor.detach().to(torch::kCPU, torch::kFloat32).contiguous();
  RowMatrix matrix(flat.size(0), flat.dim() > 1 ? flat.size(1) : 1);
  std::memcpy(matrix.data(), flat.data_ptr<float>(),
              static_cast<std::size_t>(flat.numel()) * sizeof(float));
  return matrix;
}

/// Returns the message of a libtorch exception without its backtrace.
std::string firstLine(const std::exception& error) {
  const std::string text = error.what();
  return text.substr(0, text.find('\n'));
}

TrainingLosses& operator+=(TrainingLosses& sum, const TrainingLosses& other) {
  sum.ego += other.ego;
  sum.heading += other.heading;
  sum.offset += other.offset;
  sum.selection += other.selection;
  sum.total += other.total;
  return sum;
}

TrainingLosses weighed(const TrainingLosses& losses, double weight) {
  return {losses.ego * weight, losses.heading * weight, losses.offset * weight,
          losses.selection * weight, losses.total * weight};
}

}  // namespace

struct PatternTrainer::State {
  PatternFeatureOptions features;
  PatternNetworkOptions network;
  TrainingOptions options;
  torch::Device device{torch::kCPU};
  std::uint64_t seed = 0;
  int epochs = 0;
  std::int64_t steps = 0;
  PatternModule module{nullptr};
  PatternModule average{nullptr};
  std::unique_ptr<torch::optim::AdamW> optimizer;

  torch::Tensor total(const BatchLosses& losses) const {
    return losses.ego + options.heading_weight * losses.heading +
           options.offset_weight * losses.offset + options.selection_weight * losses.selection;
  }

  TrainingLosses numbers(const BatchLosses& losses) const {
    return {losses.ego.item<double>(), losses.heading.item<double>(), losses.offset.item<double>(),
            losses.selection.item<double>(), total(losses).item<double>()};
  }

  void setRate(double steps_in_all) {
    const double done = static_cast<double>(steps) / steps_in_all;
    const double rising = std::min(done / kWarmUp, 1.0);
    const double rate =
        options.learning_rate * rising * 0.5 * (1.0 + std::cos(M_PI * std::min(done, 1.0)));
    for (auto& group : optimizer->param_groups()) {
      static_cast<torch::optim::AdamWOptions&>(group.options()).lr(std::max(rate, 1e-6));
    }
  }

  /// Restores zero gradients after loading: a layer that was trained once keeps following its
  /// momentum, for which AdamW needs a gradient. Without clips the candidate layers were never
  /// trained and must stay without.
  void resumeGradients() {
    if (optimizer->state().size() < module->parameters().size()) return;
    for (torch::Tensor& parameter : module->parameters()) {
      parameter.mutable_grad() = torch::zeros_like(parameter);
    }
  }

  void followAverage() {
    const torch::NoGradGuard no_gradients;
    const double decay = std::min(
        kAverageDecay, (1.0 + static_cast<double>(steps)) / (10.0 + static_cast<double>(steps)));
    auto targets = average->parameters();
    const auto sources = module->parameters();
    for (std::size_t i = 0; i < targets.size(); ++i) {
      targets[i].mul_(decay).add_(sources[i], 1.0 - decay);
    }
  }

  /// Trains one step. Returns the losses of the batch.
  TrainingLosses step(const std::vector<TrainingDraw>& draws, double steps_in_all) {
    setRate(steps_in_all);
    optimizer->zero_grad();
    const BatchLosses losses = lossesOf(module, movedTo(batchOf(draws, features, options), device));
    total(losses).backward();
    torch::nn::utils::clip_grad_norm_(module->parameters(), options.max_gradient);
    optimizer->step();
    ++steps;
    followAverage();
    return numbers(losses);
  }

  PatternWeights exported(const PatternModule& from) const {
    PatternWeights weights;
    weights.features = features;
    weights.network = network;
    const auto parameters = from->named_parameters();
    for (const auto& shape : layerShapes(network)) {
      LinearWeights& layer = weights.layers[shape.first];
      layer.matrix = toMatrix(parameters[shape.first + ".weight"]);
      layer.bias = toMatrix(parameters[shape.first + ".bias"]).col(0);
    }
    return weights;
  }
};

PatternTrainer::PatternTrainer(const PatternFeatureOptions& features,
                               const PatternNetworkOptions& network, const TrainingOptions& options,
                               const std::string& device, int threads, std::uint64_t seed)
    : state_(std::make_unique<State>()) {
  state_->device = trainingDevice(device);
  torch::set_num_threads(threads);
  torch::manual_seed(seed);
  state_->features = features;
  state_->network = network;
  state_->options = options;
  state_->seed = seed;
  state_->module = PatternModule(network, options.dropout, options.context_dropout);
  state_->average = PatternModule(network, options.dropout, options.context_dropout);
  state_->average->eval();
  const torch::NoGradGuard no_gradients;
  auto targets = state_->average->parameters();
  const auto sources = state_->module->parameters();
  for (std::size_t i = 0; i < targets.size(); ++i) targets[i].copy_(sources[i]);
  state_->module->to(state_->device);
  state_->average->to(state_->device);
  state_->optimizer = std::make_unique<torch::optim::AdamW>(
      state_->module->parameters(),
      torch::optim::AdamWOptions(options.learning_rate).weight_decay(options.weight_decay));
}

PatternTrainer::~PatternTrainer() = default;

int PatternTrainer::epochsDone() const { return state_->epochs; }

TrainingLosses PatternTrainer::trainEpoch(const std::vector<TrainingSample>& samples,
                                          const std::vector<std::size_t>& chosen,
                                          const std::function<void(std::size_t)>& on_batch) {
  State& state = *state_;
  const std::uint64_t seed = state.seed * 1000003 + static_cast<std::uint64_t>(state.epochs) + 1;
  torch::manual_seed(seed);
  std::mt19937_64 engine(seed);
  std::vector<std::size_t> order = chosen;
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[engine() % i]);
  const auto batch_size = static_cast<std::size_t>(state.options.batch);
  const std::size_t batches = (order.size() + batch_size - 1) / batch_size;
  const double steps_in_all = static_cast<double>(batches) * state.options.epochs;
  state.module->train();
  TrainingLosses sum;
  for (std::size_t first = 0; first < order.size(); first += batch_size) {
    const std::size_t last = std::min(first + batch_size, order.size());
    std::vector<TrainingDraw> draws;
    for (std::size_t i = first; i < last; ++i) {
      draws.push_back(randomDraw(samples[order[i]], state.options, engine));
    }
    sum += weighed(state.step(draws, steps_in_all), static_cast<double>(last - first));
    if (on_batch) on_batch(last);
  }
  ++state.epochs;
  return weighed(sum, 1.0 / static_cast<double>(order.size()));
}

TrainingLosses PatternTrainer::losses(const std::vector<TrainingSample>& samples,
                                      const std::vector<std::size_t>& chosen) {
  const torch::NoGradGuard no_gradients;
  State& state = *state_;
  TrainingLosses sum;
  for (std::size_t first = 0; first < chosen.size(); first += kLossBatch) {
    const std::size_t last = std::min(first + kLossBatch, chosen.size());
    std::vector<TrainingDraw> draws;
    std::mt19937_64 engine(state.seed + first);
    for (std::size_t i = first; i < last; ++i) {
      draws.push_back(evenDraw(samples[chosen[i]], state.options, &engine));
    }
    const PatternBatch batch = movedTo(batchOf(draws, state.features, state.options), state.device);
    sum +=
        weighed(state.numbers(lossesOf(state.average, batch)), static_cast<double>(last - first));
  }
  return weighed(sum, 1.0 / static_cast<double>(std::max<std::size_t>(chosen.size(), 1)));
}

PatternWeights PatternTrainer::weights() const { return state_->exported(state_->average); }

PatternWeights PatternTrainer::currentWeights() const { return state_->exported(state_->module); }

std::string PatternTrainer::state() const {
  torch::serialize::OutputArchive archive;
  torch::serialize::OutputArchive module;
  torch::serialize::OutputArchive average;
  torch::serialize::OutputArchive optimizer;
  state_->module->save(module);
  state_->average->save(average);
  state_->optimizer->save(optimizer);
  archive.write("module", module);
  archive.write("average", average);
  archive.write("optimizer", optimizer);
  archive.write("progress", torch::tensor({static_cast<std::int64_t>(state_->epochs), state_->steps,
                                           static_cast<std::int64_t>(state_->seed)},
                                          torch::kInt64));
  std::ostringstream bytes;  // writing an archive to a file directly aborts on errors
  archive.save_to(bytes);
  return bytes.str();
}

void PatternTrainer::load(const std::string& path) {
  try {
    torch::serialize::InputArchive archive;
    archive.load_from(path, state_->device);
    torch::Tensor progress;
    archive.read("progress", progress);
    progress = progress.to(torch::kCPU);
    if (progress[2].item<std::int64_t>() != static_cast<std::int64_t>(state_->seed)) {
      throw TrainingError("it has another seed");
    }
    torch::serialize::InputArchive module;
    torch::serialize::InputArchive average;
    torch::serialize::InputArchive optimizer;
    archive.read("module", module);
    archive.read("average", average);
    archive.read("optimizer", optimizer);
    state_->module->load(module);
    state_->average->load(average);
    state_->optimizer->load(optimizer);
    state_->resumeGradients();
    state_->epochs = static_cast<int>(progress[0].item<std::int64_t>());
    state_->steps = progress[1].item<std::int64_t>();
  } catch (const std::exception& error) {
    throw TrainingError(path +
                        ": cannot be read as the state of this training: " + firstLine(error));
  }
}

double PatternTrainer::lossAndGradients(const std::vector<TrainingSample>& samples,
                                        std::map<std::string, std::vector<double>>* gradients) {
  State& state = *state_;
  state.module->eval();
  state.module->to(torch::kFloat64);
  std::vector<TrainingDraw> draws;
  for (const TrainingSample& sample : samples) draws.push_back(evenDraw(sample, state.options));
  const PatternBatch batch =
      movedTo(batchOf(draws, state.features, state.options), state.device, torch::kFloat64);
  state.module->zero_grad();
  const torch::Tensor loss = state.total(lossesOf(state.module, batch));
  if (gradients) {
    loss.backward();
    for (const auto& entry : state.module->named_parameters()) {
      const torch::Tensor flat = entry.value().grad().to(torch::kCPU).contiguous().view(-1);
      std::vector<double>& numbers = (*gradients)[entry.key().substr(0, entry.key().find('.'))];
      numbers.insert(numbers.end(), flat.data_ptr<double>(),
                     flat.data_ptr<double>() + flat.numel());
    }
  }
  return loss.item<double>();
}

void PatternTrainer::nudge(const std::string& layer, std::size_t number, double change) {
  const torch::NoGradGuard no_gradients;
  auto parameters = state_->module->named_parameters();
  torch::Tensor matrix = parameters[layer + ".weight"];
  const auto size = static_cast<std::size_t>(matrix.numel());
  torch::Tensor flat = number < size ? matrix.view(-1) : parameters[layer + ".bias"].view(-1);
  flat[static_cast<std::int64_t>(number < size ? number : number - size)] += change;
}

}  // namespace forge
