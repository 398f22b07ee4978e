#include <torch/torch.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <random>

#include "collision_forge/batch/progress_line.h"
#include "collision_forge/data/collide_clip.h"
#include "collision_forge/data/collide_set.h"
#include "collision_forge/generators/generator_file.h"
#include "collision_forge/training/run_folder.h"
#include "collision_forge/training/training_device.h"

namespace forge {
namespace {

constexpr std::size_t kErrorBatch = 256;

/// Mean distances between what is driven and what came over one iteration, m.
struct DriveErrors {
  double all = 0.0;       ///< of all agents and frames
  double attacker = 0.0;  ///< of the attacker's frames
};

/// The clips of a run's splits, in the order of their paths, but for those of `left_out` scenes.
std::vector<TrafficClip> collectTraffic(const TrainingRun& run,
                                        const std::set<std::string>& left_out) {
  std::vector<std::string> paths;
  for (const std::string& split : run.sources.splits) {
    for (std::string& path : listCollideClips(run.sources.collide, split)) {
      if (left_out.count(parseCollideName(path).scene) == 0) paths.push_back(std::move(path));
    }
  }
  ProgressLine reading("reading");
  std::vector<TrafficClip> clips;
  for (const std::string& path : paths) {
    clips.push_back(
        trafficOf(readCollideClip(path), run.options.evaluation.collide, run.generators.traffic));
    reading.show(clips.size(), paths.size());
  }
  return clips;
}

class GeneratorTrainer {
 public:
  GeneratorTrainer(const TrainingRun& run, const std::vector<TrafficClip>& clips)
      : run_(run),
        traffic_(run.generators.traffic),
        device_(trainingDevice(run.device)),
        header_{run.generator, readText(run.config + "/generators.yaml"), traffic_.history_frames},
        generator_(makeGenerator(run.generator, run.generators, device_, run.seed)) {
    std::vector<std::string> scenes;
    for (const TrafficClip& clip : clips) scenes.push_back(clip.scene);
    const SampleSplit split = splitByScene(scenes, run.generators.validation_share, run.seed);
    for (const std::size_t i : split.training) append(windowsOf(clips[i], traffic_), training_);
    for (const std::size_t i : split.validation) append(windowsOf(clips[i], traffic_), validation_);
    if (training_.empty()) throw TrainingError("there is nothing to train on");
    if (validation_.empty()) validation_ = training_;
  }

  void run() {
    if (std::filesystem::exists(statePath(run_))) load();
    int& epoch = header_.epochs;
    EpochTable table(run_.out + "/metrics.csv", columns(), epoch);
    ProgressLine progress("training");
    const int first = epoch;
    int stop = generator_->epochs();
    if (run_.stop_after > 0) stop = std::min(stop, run_.stop_after);
    std::cout << training_.size() << " windows, and " << validation_.size()
              << " to tell the best epoch\n";
    while (epoch < stop) {
      const auto show = [&](double share) {
        progress.show(
            (epoch - first + share) / (stop - first),
            "epoch " + std::to_string(epoch + 1) + " of " + std::to_string(generator_->epochs()));
      };
      std::vector<double> row = trainEpoch(epoch, show);
      ++epoch;
      const DriveErrors errors = errorsOn(validation_);
      row.insert(row.end(), {errors.attacker, errors.all});
      if (table.add(row)) writeGenerator(run_.out + "/weights.pt", header_, *generator_, false);
      table.drawCurves(run_.out + "/curves.png", "Training of " + run_.generator,
                       {{"validation_attacker", "attacker's error on validation, m"},
                        {"validation_all", "everybody's error on validation, m"}},
                       run_.drawing);
      writeGenerator(statePath(run_), header_, *generator_, true);
      std::cout << table.lastRow() << '\n' << std::flush;
    }
  }

 private:
  static void append(const std::vector<TrafficWindow>& more, std::vector<TrafficWindow>& windows) {
    windows.insert(windows.end(), more.begin(), more.end());
  }

  std::vector<std::string> columns() const {
    std::vector<std::string> names = generator_->lossNames();
    names.insert(names.end(), {"validation_attacker", "validation_all"});
    return names;
  }

  void load() {
    header_.epochs = readGeneratorHeader(statePath(run_), run_.generator).epochs;
    readGenerator(statePath(run_), *generator_, true);
  }

  TrafficBatch onDevice(TrafficBatch batch) const {
    return {batch.poses.to(device_), batch.seen.to(device_), batch.condition.to(device_)};
  }

  /// Means of the losses over the steps that have them.
  std::vector<double> trainEpoch(int epoch, const std::function<void(double)>& show) {
    const std::uint64_t seed = run_.seed * 1000003 + static_cast<std::uint64_t>(epoch) + 1;
    torch::manual_seed(seed);
    std::mt19937_64 engine(seed);
    std::vector<TrafficWindow> order = training_;
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[engine() % i]);
    generator_->network()->train();
    const auto size = static_cast<std::size_t>(generator_->batchSize());
    std::vector<double> sums(generator_->lossNames().size(), 0.0);
    std::vector<std::size_t> counts(sums.size(), 0);
    for (std::size_t first = 0; first < order.size(); first += size) {
      const std::size_t last = std::min(first + size, order.size());
      const auto begin = order.begin() + static_cast<std::ptrdiff_t>(first);
      const auto end = order.begin() + static_cast<std::ptrdiff_t>(last);
      const std::vector<double> losses =
          generator_->trainStep(onDevice(batchOf({begin, end}, traffic_, traffic_.future_frames)));
      for (std::size_t i = 0; i < losses.size(); ++i) {
        if (std::isnan(losses[i])) continue;
        sums[i] += losses[i];
        ++counts[i];
      }
      show(static_cast<double>(last) / static_cast<double>(order.size()));
    }
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] /= static_cast<double>(counts[i]);
    return sums;
  }

  DriveErrors errorsOn(const std::vector<TrafficWindow>& windows) const {
    const torch::NoGradGuard no_gradients;
    generator_->network()->eval();
    torch::Tensor sums = torch::zeros({4}, torch::kFloat64);
    for (std::size_t first = 0; first < windows.size(); first += kErrorBatch) {
      const std::size_t last = std::min(first + kErrorBatch, windows.size());
      const auto begin = windows.begin() + static_cast<std::ptrdiff_t>(first);
      const auto end = windows.begin() + static_cast<std::ptrdiff_t>(last);
      const TrafficBatch batch = onDevice(batchOf({begin, end}, traffic_, traffic_.future_frames));
      const TrafficBatch history = historyOf(batch, traffic_.history_frames);
      const torch::Tensor driven = generator_->predict(history, noiseOf(run_.seed + first));
      const torch::Tensor came = batch.poses.slice(2, traffic_.history_frames);
      const torch::Tensor apart = (driven - came).slice(3, 0, 2).norm(2, 3);
      const torch::Tensor counted = batch.seen.slice(2, traffic_.history_frames) *
                                    seenThroughout(history, traffic_.history_frames).unsqueeze(2);
      const torch::Tensor far = apart * counted;
      const auto attacker = static_cast<long>(kAttackerAgent);
      sums += torch::stack({far.sum(), counted.sum(), far.select(1, attacker).sum(),
                            counted.select(1, attacker).sum()})
                  .to(torch::kCPU, torch::kFloat64);
    }
    return {(sums[0] / sums[1]).item<double>(), (sums[2] / sums[3]).item<double>()};
  }

  const TrainingRun& run_;
  TrafficOptions traffic_;
  torch::Device device_;
  GeneratorHeader header_;
  std::unique_ptr<TrafficGenerator> generator_;
  std::vector<TrafficWindow> training_;
  std::vector<TrafficWindow> validation_;
};

}  // namespace

void trainGenerator(const TrainingRun& run) {
  if (run.sources.collide.empty()) {
    throw TrainingError("a generator is trained on clips: --collide");
  }
  const std::set<std::string> left_out = leftOutScenes(run);
  const std::string asked = "generator = " + run.generator + "\n";
  openRunFolder(run, asked + describeRun(run, 1, "generators.yaml"));
  torch::set_num_threads(run.threads);
  const std::vector<TrafficClip> clips = collectTraffic(run, left_out);
  GeneratorTrainer(run, clips).run();
}

}  // namespace forge
