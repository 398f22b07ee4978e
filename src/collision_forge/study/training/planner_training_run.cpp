#include <cstdio>
#include <iostream>
#include <numeric>
#include <stdexcept>

#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/base/files/output_lock.h"
#include "collision_forge/io/batch/progress_line.h"
#include "collision_forge/study/training/planner_trainer.h"
#include "collision_forge/study/training/train.h"

namespace forge {
namespace {

/// Returns the indices of the samples of these scenes (`is_in`), or of all other scenes.
std::vector<std::size_t> samplesOf(const std::vector<PlannerSample>& samples,
                                   const std::set<std::string>& scenes, bool is_in) {
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if ((scenes.count(samples[i].scene) > 0) == is_in) chosen.push_back(i);
  }
  return chosen;
}

std::string errorRow(const std::string& name, const DisplacementErrors& errors) {
  std::string row = "| " + name + " |";
  for (const double mean : errors.means) {
    char cell[32];
    std::snprintf(cell, sizeof(cell), " %.2f |", mean);
    row += cell;
  }
  return row + "\n";
}

std::string errorTable(const std::string& title, const DisplacementErrors& learned,
                       const DisplacementErrors& constant_velocity) {
  std::string text = "| " + title + ", mean distance, m, up to |";
  std::string line = "|---|";
  std::string moments = "| moments |";
  for (std::size_t i = 0; i < DisplacementErrors::kTimes.size(); ++i) {
    text += " " + std::to_string(static_cast<int>(DisplacementErrors::kTimes[i])) + " s |";
    line += "---|";
    moments += " " + std::to_string(learned.moments[i]) + " |";
  }
  return text + "\n" + line + "\n" + errorRow("learned", learned) +
         errorRow("constant velocity", constant_velocity) + moments + "\n";
}

/// Trains all epochs and writes planner_metrics.csv with the loss of each.
void trainOn(const std::vector<PlannerSample>& samples, const std::vector<std::size_t>& chosen,
             const TrainingRun& run, PlannerTrainer& trainer) {
  ProgressLine progress("training");
  std::string metrics = "epoch,loss\n";
  const int epochs = run.options.planner_training.epochs;
  for (int epoch = 1; epoch <= epochs; ++epoch) {
    char line[64];
    std::snprintf(line, sizeof(line), "%d,%.6f\n", epoch, trainer.trainEpoch(samples, chosen));
    metrics += line;
    progress.show(static_cast<std::size_t>(epoch), static_cast<std::size_t>(epochs));
  }
  writeText(run.out + "/planner_metrics.csv", metrics);
}

}  // namespace

void trainPlanner(const TrainingRun& run) {
  const std::set<std::string> left_out = leftOutScenes(run);
  const OutputLock lock = OutputLock::ofFolder(run.out);
  ProgressLine reading("reading");
  const std::vector<PlannerSample> samples =
      collectPlannerSamples(run.sources, run.options, run.planners,
                            [&](std::size_t done, std::size_t all) { reading.show(done, all); });
  const std::vector<std::size_t> training = samplesOf(samples, left_out, false);
  const std::vector<std::size_t> test = samplesOf(samples, left_out, true);
  if (training.empty()) {
    throw std::runtime_error("no training samples: all scenes are left out or too short");
  }
  PlannerTrainer trainer(run.options.planner_training, run.threads, run.seed);
  trainOn(samples, training, run, trainer);
  std::string table = errorTable("scenes trained on", trainer.errors(samples, training),
                                 constantVelocityErrors(samples, training));
  if (!test.empty()) {
    table += "\n" + errorTable("scenes left out", trainer.errors(samples, test),
                               constantVelocityErrors(samples, test));
  }
  trainer.save(run.out + "/planner.pt", {left_out.begin(), left_out.end()});
  writeText(run.out + "/planner_errors.md", table);
  std::cout << table;
}

}  // namespace forge
