#include "collision_forge/study/training/train.h"

#include <malloc.h>

#include <iostream>

#include "collision_forge/io/batch/progress_line.h"
#include "collision_forge/io/weights/pattern_network_file.h"
#include "collision_forge/study/training/pattern_trainer.h"
#include "collision_forge/study/training/run_folder.h"

namespace forge {
namespace {

/// Returns the column names of numbersOf().
std::vector<std::string> columns() {
  const std::vector<std::string> names = {"ego", "heading", "offset", "selection", "total"};
  std::vector<std::string> all = names;
  for (const std::string& name : names) all.push_back("validation_" + name);
  return all;
}

std::vector<double> numbersOf(const TrainingLosses& training, const TrainingLosses& validation) {
  return {training.ego,         training.heading, training.offset,    training.selection,
          training.total,       validation.ego,   validation.heading, validation.offset,
          validation.selection, validation.total};
}

/// Writes the results of an epoch: metrics, the weights if it is the best, the training state.
void record(const PatternTrainer& trainer, const std::set<std::string>& left_out,
            const TrainingRun& run, bool is_chosen, EpochTable& table,
            const std::vector<double>& numbers) {
  if (table.add(numbers) || !is_chosen) {
    PatternWeights weights = trainer.weights();
    weights.left_out_scenes.assign(left_out.begin(), left_out.end());
    writePatternWeights({weights}, run.out + "/weights.bin");
  }
  table.keep(trainer.state());
  clearLine();
  std::cout << table.lastRow() << '\n' << std::flush;
}

/// Trains all epochs, writes files and prints.
void trainOn(const std::vector<TrainingSample>& samples, const std::set<std::string>& left_out,
             const TrainingRun& run, PatternTrainer& trainer) {
  std::vector<std::string> scenes;
  for (const TrainingSample& sample : samples) scenes.push_back(sample.scene);
  const SampleSplit split = splitByScene(scenes, run.options.training.validation_share, run.seed);
  if (split.training.empty()) {
    throw std::runtime_error("no training samples: all scenes are left out or too short");
  }
  std::cout << samples.size() << " moments, " << split.validation.size()
            << " of them for validation; " << left_out.size() << " scenes left out\n";
  const int first = trainer.epochsDone();
  EpochTable table(run, columns(), first);
  ProgressLine progress("training");
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
    const TrainingLosses training = trainer.trainEpoch(samples, split.training, show);
    const bool is_chosen = !split.validation.empty();
    const TrainingLosses validation =
        is_chosen ? trainer.losses(samples, split.validation) : training;
    record(trainer, left_out, run, is_chosen, table, numbersOf(training, validation));
  }
}

}  // namespace

void trainPatternNetwork(const TrainingRun& run) {
  const LearningOptions& options = run.options;
  const std::set<std::string> left_out = leftOutScenes(run);
  const OutputLock lock = openRunFolder(run, describeRun(run, "study/training.yaml"));
  PatternTrainer trainer(options.pattern_features, options.pattern_layers, options.training,
                         run.device, run.threads, run.seed);
  if (hasState(run)) trainer.load(statePath(run));
  ProgressLine reading("reading");
  const std::vector<TrainingSample> samples = collectTrainingSamples(
      run.sources, options, left_out, run.seed,
      [&](std::size_t done, std::size_t all) { reading.show(double(done) / double(all)); });
  trainOn(samples, left_out, run, trainer);
}

}  // namespace forge

void forgeTrain(const forge::TrainingRun& run) {
  // Keeps freed memory in the process, so that large tensors are not mapped anew in each step.
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, -1);
  mallopt(M_TOP_PAD, 128 << 20);
  if (run.generator.empty()) {
    forge::trainPatternNetwork(run);
  } else {
    forge::trainGenerator(run);
  }
}
