#include <memory>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/app/planner_test_run.h"
#include "collision_forge/io/collide/collide_set.h"
#include "collision_forge/study/commands/clip_options.h"
#include "collision_forge/study/commands/study_commands.h"
#include "collision_forge/study/evaluation/clip_cases.h"
#include "collision_forge/study/settings/study_config.h"

namespace forge {
namespace {

struct Arguments : PlannerTestArguments {
  std::string collide;
  std::string split = "val";
  std::size_t limit = 0;
  ClipAttacker attacker = ClipAttacker::kRecorded;
  bool unverified = false;
  std::string method;
};

int testOnClips(const Arguments& arguments) {
  const PlannerTestRun test(arguments);
  const StudyConfig config = loadStudyConfig(arguments.config);
  ResumableFile::Options fingerprints = studyFingerprints(arguments.config);
  addWeightsOf(arguments.method, config, fingerprints);
  std::vector<std::string> paths = listCollideClips(arguments.collide, arguments.split);
  if (arguments.limit > 0 && arguments.limit < paths.size()) paths.resize(arguments.limit);
  const auto cases =
      openClipCases(paths, arguments.logs.path, arguments.attacker, arguments.method,
                    arguments.unverified ? ClipAttacks::kAll : ClipAttacks::kVerified, config);
  const std::vector<PlannerTestResult> results = test.run(*cases, fingerprints);
  test.writePage({}, {});  // the HTML report does not read COLLIDE clips
  return test.applyCriteria(results, kExitOk);
}

}  // namespace

void addTestOnClips(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app = line.add(kPlanners, "study test",
                           "Tests planners on COLLIDE clips, as forge test on scenarios.",
                           [arguments] { return testOnClips(*arguments); });
  addSource(app, arguments->logs)->required();
  CLI::Option* collide = addCollide(app, arguments->collide)->required();
  addSplit(app, arguments->split, collide);
  addLimit(app, arguments->limit, collide);
  addChoice<ClipAttacker>(app, "--drive", arguments->attacker,
                          {{"recorded", ClipAttacker::kRecorded},
                           {"history", ClipAttacker::kHistory},
                           {"replay", ClipAttacker::kReplay}},
                          "attacker; recorded: the data set's; history, replay: made by --method "
                          "in this mode");
  app.add_flag("--unverified", arguments->unverified,
               "test all attackers, hit or miss; default: only attackers with the requested "
               "collision");
  addMethod(app, arguments->method, arguments->config);
  addPlannerTestOptions(app, *arguments);
}

}  // namespace forge
