#include <dlfcn.h>

#include <memory>
#include <stdexcept>
#include <string>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/planner_test/settings/config_fingerprint.h"
#include "collision_forge/study/commands/clip_options.h"
#include "collision_forge/study/commands/study_commands.h"
#include "collision_forge/study/settings/study_config.h"
#include "collision_forge/study/training/train.h"

namespace forge {
namespace {

int train(TrainingRun& run) {
  const StudyConfig config = loadStudyConfig(run.config);
  run.config_files = configFingerprints(run.config);
  run.config_files.merge(studyFingerprints(run.config));
  run.options = config;
  run.generators = isPublishedNetwork(run.generator) ? config.published_network : config.generators;
  // Loading libtorch takes seconds, so only this command loads it.
  void* library = dlopen("libcollision_forge_training.so", RTLD_NOW);
  if (library == nullptr) {
    throw std::runtime_error(std::string("this build cannot train (see docs/training.md): ") +
                             dlerror());
  }
  void* function = dlsym(library, "forgeTrain");
  if (function == nullptr) throw std::runtime_error(dlerror());
  reinterpret_cast<decltype(&forgeTrain)>(function)(run);
  return kExitOk;
}

}  // namespace

void addTrain(CommandLine& line) {
  const auto run = std::make_shared<TrainingRun>();
  CLI::App& app =
      line.add(kTraining, "study train", "Trains the collision-pattern network on logs and clips.",
               [run] { return train(*run); });
  addSource(app, run->sources.logs)->required();
  CLI::Option* collide = addCollide(app, run->sources.collide);
  collide->description(
      "folder of COLLIDE clips, whose maps are in --source; with --version, the logs in --source "
      "are training data, too");
  app.add_option("--splits", run->sources.splits, "splits of the clips to train on")
      ->default_val(std::vector<std::string>{"train"});
  addOut(app, run->out, "folder of the run; resumes an interrupted run");
  app.add_option("--device", run->device, "device: cpu or cuda")->capture_default_str();
  app.add_option("--folds", run->folds, "number of folds of the scenes")
      ->check(CLI::Range(2, 1000))
      ->capture_default_str();
  app.add_option("--fold", run->fold, "fold to leave out, from 1; 0: none")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  addJobs(app, run->sources.jobs, "threads for reading data");
  app.add_option("--threads", run->threads, "threads for training")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  addSeed(app, run->seed, "random seed of initial weights, sample order and folds");
  app.add_option("--stop-after", run->stop_after, "stop after this epoch; 0: the last")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--generator", run->generator,
                 "train this learned baseline on clips instead of the network")
      ->transform(oneOf(trafficModelNames()))
      ->needs(collide);
  addConfig(app, run->config);
  app.parse_complete_callback([run] {
    if (run->fold <= run->folds) return;
    throw CLI::ValidationError(
        "--fold", std::to_string(run->fold) + " is above --folds = " + std::to_string(run->folds));
  });
}

}  // namespace forge
