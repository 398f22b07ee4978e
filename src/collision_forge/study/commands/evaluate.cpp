#include <optional>
#include <stdexcept>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
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
               "redistribute the published splits train and val so that they share no scene")
      ->needs(collide);
  app.add_flag("--seen-scenes", arguments.plan.seen_scenes,
               "use models trained on all scenes, as if splits shared scenes; default: on all "
               "except the clip's own")
      ->needs(collide);
  addLimit(app, arguments.limit, collide);
}

void addPlan(CLI::App& app, EvaluationPlan& plan) {
  addChoice<Protocol>(app, "--protocol", plan.protocol,
                      {{"strict", Protocol::kStrict}, {"published", Protocol::kPublished}},
                      "evaluation protocol; requests: only strict");
  app.add_option("--method", plan.method,
                 "method to measure besides the baselines; default: recorded for clips, search for "
                 "requests");
  addMode(app, plan.mode, true);
  app.add_option("--seeds", plan.seeds,
                 "number of seeds of a seeded method, results are pooled; clips: 0, 1, ...; "
                 "requests: counted from the request's seed")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
}

void addCrash(CLI::App& app, EvaluationArguments& arguments, CLI::Option* requests) {
  addChoice<std::optional<LimitSet>>(
      app, "--limits", arguments.limits,
      {{"drivable", LimitSet::kDrivable}, {"strict", LimitSet::kStrict}},
      "limits of the attackers' motion; default: crash_definition.yaml; clips always use strict")
      ->needs(requests);
  addChoice<std::optional<bool>>(app, "--believable", arguments.believable,
                                 {{"true", true}, {"false", false}},
                                 "true: attackers must drive plausibly; default: "
                                 "crash_definition.yaml")
      ->needs(requests);
}

/// Completes and checks the plan after all options are parsed. Throws CLI::ValidationError for an
/// unknown method (clips have more methods than the configuration) and for contradicting options.
void completePlan(const CLI::App& app, const ConfigFolder& folder, bool is_of_clips,
                  EvaluationPlan& plan) {
  if (!is_of_clips && app.count("--method") == 0) plan.method = "search";
  if (is_of_clips && plan.mode == Mode::kAdaptive && isBaseline(plan.method)) {
    throw CLI::ValidationError(
        "--mode", "the baseline " + plan.method + " is not adaptive; choose another --method");
  }
  try {
    const StudyConfig config = loadStudyConfig(folder);
    MethodRegistry methods = loadMethods(config);
    if (is_of_clips) methods = clipMethods(methods, nullptr, config.evaluation);
    plan.is_seeded = methods.at(plan.method).is_seeded;
  } catch (const std::invalid_argument& error) {
    throw CLI::ValidationError("--method", error.what());
  } catch (const std::runtime_error&) {
    return;  // the run loads the configuration again and reports its errors
  }
  if (!is_of_clips && plan.protocol != Protocol::kStrict) {
    throw CLI::ValidationError("--protocol", std::string(toString(plan.protocol)) +
                                                 " needs --collide; requests support only strict");
  }
}

int evaluate(const EvaluationArguments& arguments) {
  return arguments.requests.empty() ? evaluateClips(arguments) : evaluateRequests(arguments);
}

}  // namespace

void addEvaluate(CommandLine& line) {
  const auto arguments = std::make_shared<EvaluationArguments>();
  CLI::App& app =
      line.add(kMeasuring, "study evaluate",
               "Measures a method and baselines on COLLIDE clips or on requests over logs.",
               [arguments] { return evaluate(*arguments); });
  addSource(app, arguments->logs)->required();
  CLI::Option_group* source = app.add_option_group("test set");
  CLI::Option* collide = addCollide(*source, arguments->collide);
  CLI::Option* requests =
      source->add_option("--requests", arguments->requests, "request list of forge requests")
          ->check(CLI::ExistingFile);
  source->require_option(1);
  addClips(app, *arguments, collide);
  addScenes(app, arguments->scenes)->needs(requests);
  addOut(app, arguments->out,
         "output folder for results.csv, table.md and table.csv; resumes an interrupted run");
  addPlan(app, arguments->plan);
  addCrash(app, *arguments, requests);
  addJobs(app, arguments->jobs, "clips or requests evaluated in parallel");
  addConfig(app, arguments->config);
  app.parse_complete_callback([&app, arguments] {
    completePlan(app, arguments->config, arguments->requests.empty(), arguments->plan);
  });
}

}  // namespace forge
