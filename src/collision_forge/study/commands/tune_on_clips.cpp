#include <memory>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/app/planner_tuning_run.h"
#include "collision_forge/io/collide/collide_set.h"
#include "collision_forge/study/commands/clip_options.h"
#include "collision_forge/study/commands/study_commands.h"
#include "collision_forge/study/evaluation/clip_cases.h"
#include "collision_forge/study/settings/study_config.h"

namespace forge {
namespace {

struct Arguments : TuningArguments {
  std::string collide;
  std::string split = "val";
  std::string train_method;
  std::string test_method;
};

/// Opens the clips of training and test scenes with all attackers, hit or miss: most attacks of a
/// learned baseline do not meet the request.
TuningCases openClips(const Arguments& arguments, const StudyConfig& config) {
  const ClipHalves halves = halvesByScene(listCollideClips(arguments.collide, arguments.split));
  const auto open = [&](const std::vector<std::string>& paths, const std::string& method) {
    return openClipCases(paths, arguments.logs.path, ClipAttacker::kHistory, method,
                         ClipAttacks::kAll, config);
  };
  ResumableFile::Options fingerprints = studyFingerprints(arguments.config);
  addWeightsOf(arguments.train_method, config, fingerprints);
  addWeightsOf(arguments.test_method, config, fingerprints);
  return {open(halves.first, arguments.train_method),
          open(halves.second, arguments.test_method),
          {},
          std::move(fingerprints)};
}

/// --train-method and --test-method.
void addAttackers(CLI::App& app, Arguments& arguments) {
  const auto add = [&](const std::string& name, std::string& method, const std::string& which) {
    app.add_option(name, method,
                   "method that makes the attackers of the " + which +
                       " clips in history mode, hit or miss; default: the built-in search");
  };
  add("--train-method", arguments.train_method, "training");
  add("--test-method", arguments.test_method, "test");
  app.parse_complete_callback([&arguments] {
    for (const auto& [name, method] : {std::pair("--train-method", arguments.train_method),
                                       std::pair("--test-method", arguments.test_method)}) {
      if (!method.empty()) checkMethod(name, method, arguments.config);
    }
  });
}

}  // namespace

void addTuneOnClips(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app =
      line.add(kPlanners, "study tune",
               "Tunes a planner on COLLIDE clips, as forge tune on scenarios.", [arguments] {
                 const StudyConfig config = loadStudyConfig(arguments->config);
                 return tunePlanner(*arguments,
                                    [&](const Config&) { return openClips(*arguments, config); });
               });
  CLI::Option* collide = addCollide(app, arguments->collide)
                             ->description(
                                 "folder of COLLIDE clips, contains trajectory/SPLIT; every other "
                                 "scene is for tuning, the rest for the comparison")
                             ->required();
  addSplit(app, arguments->split, collide);
  addAttackers(app, *arguments);
  addTuningOptions(app, *arguments);
}

}  // namespace forge
