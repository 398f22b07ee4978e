#include <optional>
#include <stdexcept>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/app/report.h"
#include "collision_forge/io/weights/pattern_network_file.h"
#include "collision_forge/study/commands/clip_options.h"
#include "collision_forge/study/commands/evaluation.h"
#include "collision_forge/study/commands/study_commands.h"
#include "collision_forge/study/evaluation/clip_methods.h"
#include "collision_forge/study/settings/study_config.h"

namespace forge {
namespace {

void addClips(CLI::App& app, EvaluationArguments& arguments, CLI::Option* collide) {
  addSplit(app, arguments.split, collide);
  app.add_flag("--by-scene", arguments.by_scene,
               "deal published train and val anew, so that no scene is in both")
      ->needs(collide);
  app.add_flag("--seen-scenes", arguments.plan.seen_scenes,
               "foresee by what was learned from all scenes, as where splits share scenes; by "
               "default without the clip's own")
      ->needs(collide);
  addLimit(app, arguments.limit, collide);
}

void addPlan(CLI::App& app, EvaluationPlan& plan) {
  addChoice<Protocol>(app, "--protocol", plan.protocol,
                      {{"strict", Protocol::kStrict}, {"published", Protocol::kPublished}},
                      "how crashes are judged; of requests strict alone");
  app.add_option("--method", plan.method,
                 "measured beside the baselines; recorded by default, of requests search");
  addMode(app, plan.mode, true);
  app.add_option("--seeds", plan.seeds,
                 "of a search, all pooled: 0 to this minus one; of requests counted from theirs")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
}

void addCrash(CLI::App& app, EvaluationArguments& arguments, CLI::Option* requests) {
  addChoice<std::optional<LimitSet>>(
      app, "--limits", arguments.limits,
      {{"drivable", LimitSet::kDrivable}, {"strict", LimitSet::kStrict}},
      "that attackers keep; see crash_definition.yaml. Clips are judged by the strict ones")
      ->needs(requests);
  addChoice<std::optional<bool>>(app, "--believable", arguments.believable,
                                 {{"true", true}, {"false", false}},
                                 "attackers drive as drivers do; see crash_definition.yaml. With "
                                 "false the angle bands are measured, too")
      ->needs(requests);
}

/// The methods are those that the configuration knows; of clips there are more.
void completePlan(const CLI::App& app, const ConfigFolder& folder, bool is_of_clips,
                  EvaluationPlan& plan) {
  if (plan.protocol == Protocol::kPublished && app.count("--report") > 0) {
    throw CLI::ValidationError("--report", "a page is of the strict protocol alone");
  }
  if (!is_of_clips && app.count("--method") == 0) plan.method = "search";
  if (is_of_clips && plan.mode == Mode::kAdaptive && isBaseline(plan.method)) {
    throw CLI::ValidationError("--mode", "nobody reacts in the baseline " + plan.method +
                                             ": adaptive needs another --method");
  }
  try {
    const StudyConfig config = loadStudyConfig(folder);
    MethodRegistry methods = loadMethods(config);
    if (is_of_clips) methods = clipMethods(methods, nullptr, config.evaluation);
    plan.is_seeded = methods.at(plan.method).is_seeded;
  } catch (const std::invalid_argument& error) {
    throw CLI::ValidationError("--method", error.what());
  } catch (const std::runtime_error&) {
    return;  // the run reads the configuration again and says what is wrong with it
  }
  if (!is_of_clips && plan.protocol != Protocol::kStrict) {
    throw CLI::ValidationError("--protocol",
                               std::string(toString(plan.protocol)) + " is of clips alone");
  }
}

int evaluate(const EvaluationArguments& arguments) {
  return arguments.requests.empty() ? evaluateClips(arguments) : evaluateRequests(arguments);
}

}  // namespace

void addEvaluate(CommandLine& line) {
  const auto arguments = std::make_shared<EvaluationArguments>();
  CLI::App& app = line.add(
      kMeasuring, "study evaluate",
      "Measures a method, and baselines beside it, on clips of COLLIDE or on requests over logs.",
      [arguments] { return evaluate(*arguments); });
  addSource(app, arguments->logs)->required();
  CLI::Option_group* source = app.add_option_group("what is evaluated");
  CLI::Option* collide = addCollide(*source, arguments->collide);
  CLI::Option* requests =
      source->add_option("--requests", arguments->requests, "list of forge requests")
          ->check(CLI::ExistingFile);
  source->require_option(1);
  addClips(app, *arguments, collide);
  addScenes(app, arguments->scenes)->needs(requests);
  addOut(app, arguments->out,
         "folder for results.csv, table.md and charts; a run that was interrupted goes on there");
  addPlan(app, arguments->plan);
  addCrash(app, *arguments, requests);
  addJobs(app, arguments->jobs, "clips or requests at a time, in every rank of mpirun");
  addReportOption(app, arguments->report);
  addConfig(app, arguments->config);
  app.parse_complete_callback([&app, arguments] {
    completePlan(app, arguments->config, arguments->requests.empty(), arguments->plan);
  });
}

}  // namespace forge
