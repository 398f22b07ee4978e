#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/app/planner_test_run.h"
#include "collision_forge/app/until_hit.h"
#include "collision_forge/io/batch/progress_line.h"
#include "collision_forge/io/weights/pattern_network_file.h"
#include "collision_forge/planner_test/trials/request_cases.h"

namespace forge {
namespace {

struct Arguments : PlannerTestArguments {
  std::vector<std::string> scenarios;
  bool until_hit = false;
  std::vector<std::string> scenes;
  std::vector<std::string> types;
  CatalogueChoice catalogue;
  std::optional<std::size_t> tries;
  std::uint64_t seed = 0;
  std::string method;
};

RequestListOptions listOf(const Arguments& arguments, const Config& config) {
  RequestListOptions list = config.requests;
  if (!arguments.types.empty()) list.types = typesNamed(arguments.types);
  return list;
}

std::vector<CatalogueCell> cellsOf(const Arguments& arguments) {
  std::vector<CatalogueCell> cells;
  if (arguments.catalogue.name.empty()) return cells;
  for (const CatalogueEntry& entry : arguments.catalogue.entries(arguments.config)) {
    cells.insert(cells.end(), entry.cells.begin(), entry.cells.end());
  }
  if (cells.empty()) throw std::invalid_argument("none of these scenarios can be requested");
  return cells;
}

/// Random collision requests for scenes, the cases of --until-hit. Their order is independent of
/// the order of scenes, so scenes are cached.
struct DrawnCases {
  static constexpr std::size_t kScenesKept = 64;

  DrawnCases(const Arguments& arguments, const Config& config)
      : scenes(arguments.logs, arguments.scenes, config, kScenesKept, printWarnings, showReading()),
        requests(
            scenes, loadMethod(arguments.method, config, config.attack), config,
            {listOf(arguments, config), arguments.tries.value_or(config.planners.until_hit.tries),
             arguments.seed, cellsOf(arguments),
             [this](std::size_t done, std::size_t count) { progress.show(done, count); }}) {}

  ProgressLine progress{"scenes"};
  SceneSource scenes;
  RequestCases requests;
};

int testOnDraw(const Arguments& arguments) {
  const PlannerTestRun test(arguments);
  const DrawnCases drawn(arguments, test.config());
  ResumableFile::Options fingerprints;
  addWeightsOf(arguments.method, test.config(), fingerprints);
  const std::vector<PlannerTestResult> results = test.run(drawn.requests, fingerprints);
  reportWeaknesses(drawn.requests, results, KeptDrives(test.resultsPath()), arguments.out,
                   test.config());
  const std::string weaknesses = arguments.out + "/weaknesses.jsonl";
  if (std::filesystem::file_size(weaknesses) == 0) {
    test.writePage({}, {});
  } else {
    test.writePage({weaknesses}, arguments.logs);
  }
  return test.applyCriteria(results, exitAfterUnreadable(drawn.requests.unreadable()));
}

int testOnScenarios(const Arguments& arguments) {
  const PlannerTestRun test(arguments);
  const auto cases =
      openScenarioCases(arguments.scenarios, arguments.logs,
                        static_cast<std::size_t>(arguments.jobs) + 1, test.config(), showReading());
  const std::vector<PlannerTestResult> results = test.run(*cases);
  test.writePage(arguments.scenarios, arguments.logs);
  return test.applyCriteria(results, kExitOk);
}

int test(Arguments arguments) {
  if (arguments.policies.empty()) {
    arguments.policies = {arguments.until_hit ? "adaptive" : "fixed"};
  }
  return arguments.until_hit ? testOnDraw(arguments) : testOnScenarios(arguments);
}

}  // namespace

void addTest(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  arguments->policies.clear();
  CLI::App& app = line.add(
      kPlanners, "test", "Tests planners in closed loop against attacks; resumes interrupted runs.",
      [arguments] { return test(*arguments); });
  addSource(app, arguments->logs)->required();
  CLI::Option_group* source = app.add_option_group("test cases");
  source->add_option("--scenarios", arguments->scenarios, "scenario files of forge generate");
  CLI::Option* until_hit =
      source->add_flag("--until-hit", arguments->until_hit,
                       "falsification: tests randomly drawn collisions of the scenes and writes "
                       "the weaknesses of the planners, worst first");
  source->require_option(1);
  addScenes(app, arguments->scenes)->needs(until_hit);
  CLI::Option* types = app.add_option(
      "--types", arguments->types,
      "collision types to draw from; any: all; default: the first five of " + collisionTypeWords());
  types->check(checkType)->needs(until_hit);
  addCatalogue(app, types, arguments->catalogue);
  app.get_option("--catalogue")->needs(until_hit);
  app.add_option("--tries", arguments->tries,
                 "number of collisions to draw; default: planners.yaml")
      ->check(CLI::PositiveNumber)
      ->needs(until_hit);
  addSeed(app, arguments->seed, "random seed of --until-hit")->needs(until_hit);
  addMethod(app, arguments->method, arguments->config)->needs(until_hit);
  addPolicies(app, arguments->policies, "adaptive with --until-hit, else fixed");
  addPlannerTestOptions(app, *arguments);
}

}  // namespace forge
