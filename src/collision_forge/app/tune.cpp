#include <memory>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/app/planner_tuning_run.h"
#include "collision_forge/planner_test/trials/planner_tuning.h"

namespace forge {
namespace {

struct Arguments : TuningArguments {
  std::vector<std::string> train;
  std::vector<std::string> test;
};

TuningCases openScenarios(const Arguments& arguments, const Config& config) {
  const InputLimits& limits = config.input_limits;
  checkHeldOut(readScenes(arguments.train, limits), readScenes(arguments.test, limits));
  const auto open = [&](const std::vector<std::string>& paths) {
    return openScenarioCases(paths, arguments.logs, static_cast<std::size_t>(arguments.jobs) + 1,
                             config, showReading());
  };
  return {open(arguments.train), open(arguments.test), arguments.test};
}

}  // namespace

void addTune(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app = line.add(
      kPlanners, "tune",
      "Finds the best parameters of a planner by grid search; resumes interrupted runs.",
      [arguments] {
        return tunePlanner(*arguments,
                           [&](const Config& config) { return openScenarios(*arguments, config); });
      });
  app.add_option("--train", arguments->train,
                 "scenario files of forge generate, to choose the parameters")
      ->required();
  app.add_option("--test", arguments->test,
                 "scenario files of other scenes, to compare tuned and default planner")
      ->required();
  addTuningOptions(app, *arguments);
}

}  // namespace forge
