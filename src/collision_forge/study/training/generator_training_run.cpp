#include <torch/torch.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

#include "collision_forge/base/config/section.h"
#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/io/batch/progress_line.h"
#include "collision_forge/io/collide/collide_clip.h"
#include "collision_forge/io/collide/collide_set.h"
#include "collision_forge/io/logs/city_maps.h"
#include "collision_forge/study/generators/generator_file.h"
#include "collision_forge/study/generators/make_traffic_model.h"
#include "collision_forge/study/training/run_folder.h"
#include "collision_forge/study/training/train.h"
#include "collision_forge/study/training/training_device.h"

namespace forge {
namespace {

constexpr std::size_t kErrorBatch = 256;

/// Reads the clips of a run's splits, in the order of their paths, without the scenes `left_out`.
std::vector<TrafficClip> collectTraffic(const TrainingRun& run, const TrafficOptions& traffic,
                                        const std::set<std::string>& left_out) {
  std::vector<std::string> paths;
  for (const std::string& split : run.sources.splits) {
    for (std::string& path : listCollideClips(run.sources.collide, split)) {
      if (left_out.count(parseCollideName(path).scene) == 0) paths.push_back(std::move(path));
    }
  }
  CityMaps maps(run.sources.logs.path, run.options);
  ProgressLine reading("reading");
  std::vector<TrafficClip> clips;
  for (const std::string& path : paths) {
    const CollideClip clip = readCollideClip(path, run.options.input_limits);
    const auto lanes = traffic.lanes.max_lanes > 0 ? maps.at(clip.city) : nullptr;
    clips.push_back(trafficOf(clip, run.options.evaluation.collide, traffic, lanes.get()));
    reading.show(clips.size(), paths.size());
  }
  return clips;
}

class GeneratorTrainer {
 public:
  GeneratorTrainer(const TrainingRun& run, GeneratorHeader header)
      : run_(run),
        device_(trainingDevice(run.device)),
        header_(std::move(header)),
        model_(makeTrafficModel(header_.name, run.generators, device_, run.seed)) {}

  const TrafficOptions& traffic() const { return model_->traffic(); }

  /// The clips must outlive the trainer.
  void learnFrom(const std::vector<TrafficClip>& clips) {
    std::vector<std::string> scenes;
    for (const TrafficClip& clip : clips) scenes.push_back(clip.scene);
    const SampleSplit split = splitByScene(scenes, run_.generators.validation_share, run_.seed);
    for (const std::size_t i : split.training) append(windowsOf(clips[i], traffic()), training_);
    for (const std::size_t i : split.validation)
      append(windowsOf(clips[i], traffic()), validation_);
    if (training_.empty()) {
      throw TrainingError(
          "no training samples: the splits have no clip outside the left-out scenes");
    }
    if (validation_.empty()) validation_ = training_;
  }

  void run() {
    if (hasState(run_)) load();
    int& epoch = header_.epochs;
    EpochTable table(run_, columns(), epoch);
    ProgressLine progress("training");
    const int first = epoch;
    int stop = model_->epochs();
    if (run_.stop_after > 0) stop = std::min(stop, run_.stop_after);
    std::cout << training_.size() << " windows, and " << validation_.size() << " for validation\n";
    while (epoch < stop) {
      const auto show = [&](double share) {
        progress.show(
            (epoch - first + share) / (stop - first),
            "epoch " + std::to_string(epoch + 1) + " of " + std::to_string(model_->epochs()));
      };
      std::vector<double> row = trainEpoch(epoch, show);
      ++epoch;
      for (const double error : errorsOn(validation_)) row.push_back(error);
      if (table.add(row)) {
        writeText(run_.out + "/weights.pt", generatorBytes(header_, *model_, false));
      }
      table.keep(generatorBytes(header_, *model_, true));
      clearLine();
      std::cout << table.lastRow() << '\n' << std::flush;
    }
  }

 private:
  static void append(const std::vector<TrafficWindow>& more, std::vector<TrafficWindow>& windows) {
    windows.insert(windows.end(), more.begin(), more.end());
  }

  std::vector<std::string> columns() const {
    std::vector<std::string> names = model_->lossNames();
    for (const std::string& name : model_->errorNames()) names.push_back("validation_" + name);
    return names;
  }

  void load() {
    header_.epochs = readGeneratorHeader(statePath(run_), run_.generator).epochs;
    readGenerator(statePath(run_), *model_, true);
  }

  /// Trains one epoch. Returns the mean of each loss over the steps that compute it.
  std::vector<double> trainEpoch(int epoch, const std::function<void(double)>& show) {
    const std::uint64_t seed = run_.seed * 1000003 + static_cast<std::uint64_t>(epoch) + 1;
    torch::manual_seed(seed);
    std::mt19937_64 engine(seed);
    std::vector<TrafficWindow> order = training_;
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[engine() % i]);
    model_->network()->train();
    const auto size = static_cast<std::size_t>(model_->batchSize());
    std::vector<double> sums(model_->lossNames().size(), 0.0);
    std::vector<std::size_t> counts(sums.size(), 0);
    for (std::size_t first = 0; first < order.size(); first += size) {
      const std::size_t last = std::min(first + size, order.size());
      const std::vector<double> losses = model_->trainStep(batchFrom(order, first, last));
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

  TrafficBatch batchFrom(const std::vector<TrafficWindow>& windows, std::size_t first,
                         std::size_t last) const {
    const auto begin = windows.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = windows.begin() + static_cast<std::ptrdiff_t>(last);
    return movedTo(batchOf({begin, end}, traffic(), traffic().future_frames), device_);
  }

  std::vector<double> errorsOn(const std::vector<TrafficWindow>& windows) const {
    const torch::NoGradGuard no_gradients;
    model_->network()->eval();
    std::vector<ErrorSum> sums(model_->errorNames().size());
    for (std::size_t first = 0; first < windows.size(); first += kErrorBatch) {
      const std::size_t last = std::min(first + kErrorBatch, windows.size());
      const auto errors =
          model_->errorsOn(batchFrom(windows, first, last), noiseOf(run_.seed + first));
      for (std::size_t i = 0; i < sums.size(); ++i) {
        sums[i].sum += errors[i].sum;
        sums[i].count += errors[i].count;
      }
    }
    std::vector<double> means;
    for (const ErrorSum& sum : sums) means.push_back(sum.sum / std::max(sum.count, 1.0));
    return means;
  }

  const TrainingRun& run_;
  torch::Device device_;
  GeneratorHeader header_;
  std::shared_ptr<TrafficModel> model_;
  std::vector<TrafficWindow> training_;
  std::vector<TrafficWindow> validation_;
};

}  // namespace

void trainGenerator(const TrainingRun& run) {
  if (run.sources.collide.empty()) {
    throw TrainingError("--generator needs clips to train on: give --collide");
  }
  const std::set<std::string> left_out = leftOutScenes(run);
  const std::string file = configFileOf(run.generator);
  const std::string asked = "generator = " + run.generator + "\n";
  const OutputLock lock = openRunFolder(run, asked + describeRun(run, file));
  torch::set_num_threads(run.threads);
  GeneratorTrainer trainer(run, {run.generator,
                                 run.config.textOfSections(file, sectionsOf(run.generator)),
                                 run.generators.traffic.history_frames,
                                 0,
                                 {left_out.begin(), left_out.end()}});
  const std::vector<TrafficClip> clips = collectTraffic(run, trainer.traffic(), left_out);
  trainer.learnFrom(clips);
  trainer.run();
}

}  // namespace forge
