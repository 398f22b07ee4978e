#include "collision_forge/training/training_run.h"

#include <malloc.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <sstream>

#include "collision_forge/batch/progress_line.h"
#include "collision_forge/data/pattern_network_file.h"
#include "collision_forge/drawing/line_chart.h"
#include "collision_forge/files/aside_file.h"
#include "collision_forge/training/pattern_trainer.h"

#ifndef COLLISION_FORGE_WITHOUT_MPI
#include "collision_forge/batch/ranks.h"
#endif

namespace forge {
namespace {

namespace fs = std::filesystem;

/// The processes that mpirun started.
TrainingRanks launchedRanks() {
#ifdef COLLISION_FORGE_WITHOUT_MPI
  return {};
#else
  const Ranks& ranks = Ranks::get();
  return {ranks.rank(), ranks.size(),
          [&ranks](std::vector<double>& numbers) { ranks.sum(numbers); }};
#endif
}

/// What a run was asked for; going on asks for the same.
std::string describe(const TrainingRun& run, int ranks) {
  std::ostringstream text;
  text << "dataroot = " << run.sources.dataroot << "\nversion = " << run.sources.version
       << "\ncollide = " << run.sources.collide << "\nsplits =";
  for (const std::string& split : run.sources.splits) text << ' ' << split;
  text << "\nfold = " << run.fold << "\nfolds = " << run.folds << "\nseed = " << run.seed
       << "\ndevice = " << run.device << "\nranks = " << ranks << "\n\n";
  std::ifstream config(run.config + "/training.yaml");
  text << config.rdbuf();
  return text.str();
}

std::string readAll(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string statePath(const TrainingRun& run) { return run.out + "/state.pt"; }

/// Makes the run folder, or checks that the one there is of the same run.
void openRun(const TrainingRun& run, int ranks) {
  const std::string path = run.out + "/run.txt";
  const std::string asked = describe(run, ranks);
  if (!fs::exists(path)) {
    if (fs::exists(statePath(run))) {
      throw std::runtime_error(statePath(run) + ": is there, but not " + path +
                               ", which says what it was made with; remove it, or write elsewhere");
    }
    fs::create_directories(run.out);
    writeText(path, asked);
    return;
  }
  std::istringstream known(readAll(path));
  std::istringstream wanted(asked);
  std::string was;
  std::string is;
  while (std::getline(wanted, is)) {
    if (!std::getline(known, was) || was != is) {
      throw std::runtime_error(path + ": the run was started with \"" + was + "\", not \"" + is +
                               "\"");
    }
  }
}

struct Split {
  std::vector<std::size_t> training;
  std::vector<std::size_t> validation;
};

Split splitByScene(const std::vector<TrainingSample>& samples, double validation_share,
                   std::uint64_t seed) {
  std::set<std::string> scenes;
  for (const TrainingSample& sample : samples) scenes.insert(sample.scene);
  std::set<std::string> held_out;
  if (validation_share > 0.0) {
    const int parts = std::max(2, static_cast<int>(std::lround(1.0 / validation_share)));
    held_out = scenesOfFold({scenes.begin(), scenes.end()}, 1, parts, seed + 1);
  }
  Split split;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    (held_out.count(samples[i].scene) > 0 ? split.validation : split.training).push_back(i);
  }
  return split;
}

constexpr const char* kMetricsHeader =
    "epoch,ego,heading,offset,selection,total,validation_ego,validation_heading,"
    "validation_offset,validation_selection,validation_total\n";

std::string metricsLine(int epoch, const TrainingLosses& training,
                        const TrainingLosses& validation) {
  char line[512];
  std::snprintf(line, sizeof(line), "%d,%.6f,%.6f,%.6f,%.6f,%.6f,%.6f,%.6f,%.6f,%.6f,%.6f\n", epoch,
                training.ego, training.heading, training.offset, training.selection, training.total,
                validation.ego, validation.heading, validation.offset, validation.selection,
                validation.total);
  return line;
}

/// What chooses the best epoch, as the metrics tell it.
double validationTotal(const std::string& line) {
  return std::stod(line.substr(line.rfind(',') + 1));
}

/// The first `epochs` epochs of what a stopped run wrote, and the best validation among them.
std::string keptMetrics(const std::string& path, int epochs, double& best) {
  std::istringstream file(readAll(path));
  std::string kept;
  std::string line;
  for (int i = 0; i <= epochs && std::getline(file, line); ++i) {
    kept += line + '\n';
    if (i > 0) best = std::min(best, validationTotal(line));
  }
  return kept;
}

/// A column of the metrics, counted from 0.
std::vector<double> columnOf(const std::string& metrics, int column) {
  std::istringstream lines(metrics);
  std::string line;
  std::getline(lines, line);
  std::vector<double> values;
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    std::string cell;
    for (int i = 0; i <= column; ++i) std::getline(cells, cell, ',');
    values.push_back(std::stod(cell));
  }
  return values;
}

void drawCurves(const std::string& path, const std::string& metrics,
                const DrawingOptions& options) {
  const LineChart chart{"Training: negative log density of the ego's place",
                        "epoch",
                        {{"training", options.attacker_color, columnOf(metrics, 1)},
                         {"validation", options.ego_color, columnOf(metrics, 6)}}};
  drawLineChart(path, chart, options);
}

/// What the run folder tells of the epochs, and the network of the best.
class RunRecord {
 public:
  RunRecord(const TrainingRun& run, int epochs_done)
      : folder_(run.out), drawing_(run.drawing), metrics_(kMetricsHeader) {
    if (epochs_done > 0) metrics_ = keptMetrics(folder_ + "/metrics.csv", epochs_done, best_);
  }

  void add(const PatternTrainer& trainer, const std::set<std::string>& left_out,
           const TrainingLosses& training, const TrainingLosses& validation, bool chooses) {
    const std::string line = metricsLine(trainer.epochsDone(), training, validation);
    metrics_ += line;
    if (!chooses || validationTotal(line) < best_) {
      best_ = validationTotal(line);
      PatternWeights weights = trainer.weights();
      weights.left_out_scenes.assign(left_out.begin(), left_out.end());
      writePatternWeights({weights}, folder_ + "/weights.bin");
    }
    writeText(folder_ + "/metrics.csv", metrics_);
    drawCurves(folder_ + "/curves.png", metrics_, drawing_);
    trainer.save(folder_ + "/state.pt");
    std::cout << line << std::flush;
  }

 private:
  std::string folder_;
  const DrawingOptions& drawing_;
  std::string metrics_;
  double best_ = std::numeric_limits<double>::infinity();
};

/// Epoch after epoch on what was read; rank 0 alone writes and tells.
void trainOn(const std::vector<TrainingSample>& samples, const std::set<std::string>& left_out,
             const TrainingRun& run, bool is_first, PatternTrainer& trainer) {
  const Split split = splitByScene(samples, run.options.training.validation_share, run.seed);
  if (split.training.empty()) throw std::runtime_error("there is nothing to train on");
  if (is_first) {
    std::cout << samples.size() << " moments, " << split.validation.size()
              << " of them to tell the best epoch; " << left_out.size() << " scenes left out\n";
  }
  RunRecord record(run, trainer.epochsDone());
  ProgressLine progress("training");
  const int first = trainer.epochsDone();
  int stop = run.options.training.epochs;
  if (run.stop_after > 0) stop = std::min(stop, run.stop_after);
  while (trainer.epochsDone() < stop) {
    const int epoch = trainer.epochsDone();
    const auto show = [&](std::size_t done) {
      const double share = double(done) / double(split.training.size());
      progress.show((epoch - first + share) / (stop - first),
                    "epoch " + std::to_string(epoch + 1) + " of " +
                        std::to_string(run.options.training.epochs));
    };
    const TrainingLosses training = trainer.trainEpoch(
        samples, split.training, is_first ? std::function<void(std::size_t)>(show) : nullptr);
    if (!is_first) continue;
    const bool chooses = !split.validation.empty();
    record.add(trainer, left_out, training,
               chooses ? trainer.losses(samples, split.validation) : training, chooses);
  }
}

void trainNetwork(const TrainingRun& run) {
  const LearningOptions& options = run.options;
  const std::set<std::string> left_out = leftOutScenes(run);
  const TrainingRanks ranks = launchedRanks();
  const bool is_first = ranks.rank == 0;
  if (is_first) openRun(run, ranks.size);
  PatternTrainer trainer(options.pattern_features, options.pattern_layers, options.training,
                         run.device, run.threads, run.seed);
  trainer.trainTogether(ranks);
  if (fs::exists(statePath(run))) trainer.load(statePath(run));
  ProgressLine reading("reading");
  const std::vector<TrainingSample> samples = collectTrainingSamples(
      run.sources, options, left_out, run.seed, [&](std::size_t done, std::size_t all) {
        if (is_first) reading.show(double(done) / double(all));
      });
  trainOn(samples, left_out, run, is_first, trainer);
#ifndef COLLISION_FORGE_WITHOUT_MPI
  Ranks::get().settle();
#endif
}

}  // namespace

std::set<std::string> leftOutScenes(const TrainingRun& run) {
  if (run.fold == 0) return {};
  const std::vector<std::string> names = sceneNames(run.sources);
  if (static_cast<int>(names.size()) < run.fold) {
    throw std::runtime_error("--fold: " + std::to_string(run.fold) + " has none of the " +
                             std::to_string(names.size()) + " scenes");
  }
  return scenesOfFold(names, run.fold, run.folds, run.seed);
}

}  // namespace forge

void forgeTrainPatternNetwork(const forge::TrainingRun& run) {
  // Large tensors are kept rather than given back to the system after each step.
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, -1);
  mallopt(M_TOP_PAD, 128 << 20);
  forge::trainNetwork(run);
}
