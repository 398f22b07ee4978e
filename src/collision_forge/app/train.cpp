#include <malloc.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <sstream>

#include "collision_forge/app/progress_line.h"
#include "collision_forge/app/tool_support.h"
#include "collision_forge/app/training_data.h"
#include "collision_forge/data/pattern_network_file.h"
#include "collision_forge/drawing/line_chart.h"
#include "collision_forge/files/aside_file.h"
#include "collision_forge/settings/config.h"
#include "collision_forge/training/pattern_trainer.h"

#ifndef COLLISION_FORGE_WITHOUT_MPI
#include "collision_forge/batch/ranks.h"
#endif

namespace {

using namespace forge;
namespace fs = std::filesystem;

struct Arguments {
  TrainingSources sources;
  std::string out;
  std::string config;
  std::string device = "cpu";
  int fold = 0;
  int folds = 5;
  int threads = 1;
  int stop_after = 0;
  std::uint64_t seed = 0;
  bool resume = false;
};

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
std::string describe(const Arguments& arguments, int ranks) {
  std::ostringstream text;
  text << "dataroot = " << arguments.sources.dataroot << "\nversion = " << arguments.sources.version
       << "\ncollide = " << arguments.sources.collide << "\nsplits =";
  for (const std::string& split : arguments.sources.splits) text << ' ' << split;
  text << "\nfold = " << arguments.fold << "\nfolds = " << arguments.folds
       << "\nseed = " << arguments.seed << "\ndevice = " << arguments.device
       << "\nranks = " << ranks << "\n\n";
  std::ifstream config(arguments.config + "/training.yaml");
  text << config.rdbuf();
  return text.str();
}

std::string readAll(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Makes the run folder, or checks that the one there is of the same run.
void openRun(const Arguments& arguments, int ranks) {
  const std::string run = arguments.out + "/run.txt";
  const std::string asked = describe(arguments, ranks);
  if (!arguments.resume) {
    if (fs::exists(run)) {
      throw std::runtime_error(arguments.out + ": holds a run; go on with --resume, or remove it");
    }
    fs::create_directories(arguments.out);
    writeText(run, asked);
    return;
  }
  if (!fs::exists(run)) throw std::runtime_error(run + ": no such file; there is no run to resume");
  std::istringstream known(readAll(run));
  std::istringstream wanted(asked);
  std::string was;
  std::string is;
  while (std::getline(wanted, is)) {
    if (!std::getline(known, was) || was != is) {
      throw std::runtime_error(run + ": the run was started with \"" + was + "\", not \"" + is +
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
  RunRecord(const Arguments& arguments, const Config& config, int epochs_done)
      : folder_(arguments.out), config_(config), metrics_(kMetricsHeader) {
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
    drawCurves(folder_ + "/curves.png", metrics_, config_.drawing);
    trainer.save(folder_ + "/state.pt");
    std::cout << line << std::flush;
  }

 private:
  std::string folder_;
  const Config& config_;
  std::string metrics_;
  double best_ = std::numeric_limits<double>::infinity();
};

/// Epoch after epoch on what was read; rank 0 alone writes and tells.
void trainOn(const std::vector<TrainingSample>& samples, const std::set<std::string>& left_out,
             const Arguments& arguments, const Config& config, bool is_first,
             PatternTrainer& trainer) {
  const Split split = splitByScene(samples, config.training.validation_share, arguments.seed);
  if (split.training.empty()) throw std::runtime_error("there is nothing to train on");
  if (is_first) {
    std::cout << samples.size() << " moments, " << split.validation.size()
              << " of them to tell the best epoch; " << left_out.size() << " scenes left out\n";
  }
  RunRecord record(arguments, config, trainer.epochsDone());
  ProgressLine progress("training");
  const int first = trainer.epochsDone();
  int stop = config.training.epochs;
  if (arguments.stop_after > 0) stop = std::min(stop, arguments.stop_after);
  while (trainer.epochsDone() < stop) {
    const int epoch = trainer.epochsDone();
    const auto show = [&](std::size_t done) {
      const double share = double(done) / double(split.training.size());
      progress.show(
          (epoch - first + share) / (stop - first),
          "epoch " + std::to_string(epoch + 1) + " of " + std::to_string(config.training.epochs));
    };
    const TrainingLosses training = trainer.trainEpoch(
        samples, split.training, is_first ? std::function<void(std::size_t)>(show) : nullptr);
    if (!is_first) continue;
    const bool chooses = !split.validation.empty();
    record.add(trainer, left_out, training,
               chooses ? trainer.losses(samples, split.validation) : training, chooses);
  }
}

std::set<std::string> leftOutScenes(const Arguments& arguments) {
  if (arguments.fold == 0) return {};
  const std::vector<std::string> names = sceneNames(arguments.sources);
  if (static_cast<int>(names.size()) < arguments.fold) {
    throw std::runtime_error("--fold: " + std::to_string(arguments.fold) + " has none of the " +
                             std::to_string(names.size()) + " scenes");
  }
  return scenesOfFold(names, arguments.fold, arguments.folds, arguments.seed);
}

int train(const Arguments& arguments) {
  const Config config = loadConfig(arguments.config);
  const std::set<std::string> left_out = leftOutScenes(arguments);
  const TrainingRanks ranks = launchedRanks();
  const bool is_first = ranks.rank == 0;
  if (is_first) openRun(arguments, ranks.size);
  PatternTrainer trainer(config.pattern_features, config.pattern_layers, config.training,
                         arguments.device, arguments.threads, arguments.seed);
  trainer.trainTogether(ranks);
  const std::string state = arguments.out + "/state.pt";
  if (arguments.resume && fs::exists(state)) trainer.load(state);
  ProgressLine reading("reading");
  const std::vector<TrainingSample> samples = collectTrainingSamples(
      arguments.sources, config, left_out, arguments.seed, [&](std::size_t done, std::size_t all) {
        if (is_first) reading.show(double(done) / double(all));
      });
  trainOn(samples, left_out, arguments, config, is_first, trainer);
#ifndef COLLISION_FORGE_WITHOUT_MPI
  Ranks::get().settle();
#endif
  return kExitOk;
}

}  // namespace

int main(int argc, char** argv) {
  // Large tensors are kept rather than given back to the system after each step.
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, -1);
  mallopt(M_TOP_PAD, 128 << 20);
  Arguments arguments;
  CLI::App app("Trains the collision-pattern network on logs and clips.", "train");
  app.add_option("--dataroot", arguments.sources.dataroot, "nuScenes root, for maps and logs")
      ->required();
  app.add_option("--version", arguments.sources.version,
                 "folder of the logs' tables, as v1.0-trainval; none: no logs");
  app.add_option("--collide", arguments.sources.collide, "folder of clips; none: no clips");
  app.add_option("--splits", arguments.sources.splits, "splits of the clips")
      ->default_val(std::vector<std::string>{"train"});
  app.add_option("--out", arguments.out, "folder of the run")->required();
  app.add_option("--device", arguments.device, "cpu or cuda")->capture_default_str();
  app.add_option("--folds", arguments.folds, "parts that the scenes are dealt into")
      ->check(CLI::Range(2, 1000))
      ->capture_default_str();
  app.add_option("--fold", arguments.fold, "part that is left out, from 1; 0: none")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--jobs", arguments.sources.jobs, "threads that read")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--threads", arguments.threads, "threads that train")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--seed", arguments.seed, "of weights, order and folds")->capture_default_str();
  app.add_option("--stop-after", arguments.stop_after, "epoch to stop after; 0: the last")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_flag("--resume", arguments.resume, "go on with the run in --out");
  addConfigOption(app, arguments.config);
  app.callback([&] {
    if (arguments.fold <= arguments.folds) return;
    throw CLI::ValidationError("--fold", std::to_string(arguments.fold) + " is none of the " +
                                             std::to_string(arguments.folds) + " of --folds");
  });
  return runTool(app, argc, argv, [&] { return train(arguments); });
}
