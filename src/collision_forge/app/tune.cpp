#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <sstream>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/evaluation.h"
#include "collision_forge/app/options.h"
#include "collision_forge/app/report.h"
#include "collision_forge/app/run_config.h"
#include "collision_forge/batch/dispatch.h"
#include "collision_forge/batch/output.h"
#include "collision_forge/data/collide_set.h"
#include "collision_forge/files/aside_file.h"
#include "collision_forge/files/fingerprint.h"
#include "collision_forge/planners/planner_factory.h"
#include "collision_forge/scene/number_words.h"
#include "collision_forge/settings/config_fingerprint.h"
#include "collision_forge/study/clip_cases.h"
#include "collision_forge/trials/planner_cases.h"
#include "collision_forge/trials/planner_report.h"
#include "collision_forge/trials/planner_run.h"
#include "collision_forge/trials/planner_tuning.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::string planner = "pdm";
  std::string planner_file;
  std::string grid;
  std::vector<std::string> train;
  std::vector<std::string> test;
  std::string collide;
  std::string split = "val";
  std::string train_method;
  std::string test_method;
  LogSource logs;
  Background background = Background::kReplay;
  std::string out;
  std::string report;
  std::string config;
  int jobs = defaultJobs();
};

/// The planners.yaml that is tuned.
struct PlannersFile {
  std::string path;
  std::string text;
};

PlannersFile readPlannersFile(const std::string& config) {
  PlannersFile file{config + "/planners.yaml", ""};
  std::ifstream stream(file.path, std::ios::binary);
  std::ostringstream content;
  content << stream.rdbuf();
  if (!stream) throw std::runtime_error(file.path + ": cannot be read");
  file.text = content.str();
  return file;
}

/// Everything that every rank works with.
struct Tuning {
  const Arguments& arguments;
  const StudyConfig& config;
  const PlannersFile file;
  const std::vector<PlannerVariant> variants;
  const std::unique_ptr<PlannerCases> train;
  const std::unique_ptr<PlannerCases> test;
};

/// What is tuned on and what is compared on; no scene is in both.
struct BothCases {
  std::unique_ptr<PlannerCases> train;
  std::unique_ptr<PlannerCases> test;
};

BothCases openScenarios(const Arguments& arguments, const StudyConfig& config) {
  const InputLimits& limits = config.input_limits;
  checkHeldOut(readScenes(arguments.train, limits), readScenes(arguments.test, limits));
  const auto open = [&](const std::vector<std::string>& paths) {
    return openScenarioCases(paths, arguments.logs, static_cast<std::size_t>(arguments.jobs) + 1,
                             config, showReading());
  };
  return {open(arguments.train), open(arguments.test)};
}

/// All attackers, hit or miss: most of a learned generator's are not as asked.
BothCases openClips(const Arguments& arguments, const StudyConfig& config) {
  const ClipHalves halves = halvesByScene(listCollideClips(arguments.collide, arguments.split));
  const auto open = [&](const std::vector<std::string>& paths, const std::string& method) {
    return openClipCases(paths, arguments.logs.path, ClipAttacker::kHistory, method,
                         ClipAnswers::kAll, config);
  };
  return {open(halves.first, arguments.train_method), open(halves.second, arguments.test_method)};
}

Tuning openTuning(const Arguments& arguments, const StudyConfig& config) {
  const PlannersFile file = readPlannersFile(arguments.config);
  const PlannerGrid grid = readPlannerGrid(arguments.grid, arguments.planner);
  std::vector<PlannerVariant> variants =
      variantsOf(grid, file.path, file.text, config.attack.verification.limits);
  for (PlannerVariant& variant : variants) {
    variant.options.torchscript.file = config.planners.torchscript.file;
    variant.options.torchscript.workers = config.planners.torchscript.workers;
  }
  BothCases cases =
      arguments.collide.empty() ? openScenarios(arguments, config) : openClips(arguments, config);
  return {
      arguments, config, file, std::move(variants), std::move(cases.train), std::move(cases.test)};
}

/// What the results of both parts depend on.
ResumableFile::Options runOptions(const Tuning& tuning) {
  const Arguments& arguments = tuning.arguments;
  ResumableFile::Options options = inputsOf(tuning.config, arguments.config, arguments.logs);
  options["planner"] = arguments.planner;
  addPlannerFingerprint(options, {arguments.planner}, tuning.config.planners);
  options["background"] = arguments.background == Background::kIdm ? "idm" : "replay";
  std::string found;
  for (const PlannerVariant& variant : tuning.variants) {
    for (const auto& [key, value] : variant.values) {
      found = fingerprint(key + "=" + shortestText(value) + ";", found);
    }
  }
  options["grid"] = std::to_string(tuning.variants.size()) + " variants, fingerprint " + found;
  options["train"] = tuning.train->fingerprint();
  return options;
}

/// What is driven, for the file OUT/NAME.jsonl.
Run partRun(const Tuning& tuning, const std::string& name, const PlannerCases& cases) {
  Run run;
  run.path = (fs::path(tuning.arguments.out) / (name + ".jsonl")).string();
  run.options = runOptions(tuning);
  run.options[name] = cases.fingerprint();
  run.jobs = tuning.arguments.jobs;
  return run;
}

/// Drives every variant through the training cases; results on the master.
std::vector<PlannerTestResult> driveVariants(const Tuning& tuning) {
  return testCases(
      partRun(tuning, "train", *tuning.train), *tuning.train, [&](const PlannerCase& one) {
        return testVariants(one, tuning.arguments.planner, tuning.variants, true,
                            tuning.arguments.background, tuning.config, tuning.config.planners);
      });
}

/// The default and the tuned one.
std::vector<PlannerVariant> comparedVariants(const Tuning& tuning, std::size_t best) {
  std::vector<PlannerVariant> pair = {tuning.variants.front(), tuning.variants[best]};
  pair.back().name = "tuned";
  return pair;
}

/// Drives default and tuned planner through the held-out cases; results on the master.
std::vector<PlannerTestResult> compare(const Tuning& tuning, std::size_t best) {
  const std::vector<PlannerVariant> pair = comparedVariants(tuning, best);
  return testCases(
      partRun(tuning, "test", *tuning.test), *tuning.test, [&](const PlannerCase& one) {
        return testVariants(one, tuning.arguments.planner, pair, false, tuning.arguments.background,
                            tuning.config, tuning.config.planners);
      });
}

/// The index of the best variant; writes how all did.
std::size_t chooseBest(const Tuning& tuning, const std::vector<PlannerTestResult>& results) {
  const auto scores = scoreVariants(results, tuning.variants, tuning.config.evaluation.statistics);
  const auto best = bestVariant(scores);
  if (!best) throw std::runtime_error("there is no avoidable crash to tune on");
  writeText(tuning.arguments.out + "/variants.csv", scoresCsv(tuning.variants, scores, *best));
  return *best;
}

void report(const Tuning& tuning, std::size_t best, const std::vector<PlannerTestResult>& train,
            const std::vector<PlannerTestResult>& test) {
  const Arguments& arguments = tuning.arguments;
  const StatisticsOptions& statistics = tuning.config.evaluation.statistics;
  const PlannerValues& before = tuning.variants.front().values;
  const PlannerValues& after = tuning.variants[best].values;
  const RateTable comparison = comparisonTable(test, statistics);
  const std::string outcome = reportTitle("Tuning of " + arguments.planner, statistics) +
                              "\nBest of " + counted(tuning.variants.size(), "variant") +
                              " on the training scenarios (" + tuning.variants[best].name +
                              " of variants.csv):\n\n" + describeValues(before, after) +
                              "\nTraining: " + describeCases(train) +
                              "\nTest: " + describeCases(test) + "\n" + toMarkdown(comparison);
  std::string text = outcome;
  std::string csv = rateCsvHeader() + "\n" + toCsv(comparison);
  for (const PlannerTable& entry : plannerTables(test, {"default", "tuned"}, statistics)) {
    text += "\n" + toMarkdown(entry.table, entry.unit);
    csv += toCsv(entry.table);
  }
  writeText(arguments.out + "/planners.yaml",
            withPlannerValues(tuning.file.path, tuning.file.text, after));
  writeText(arguments.out + "/table.csv", csv);
  writeText(arguments.out + "/table.md", text);
  std::cout << outcome << "\nin " << arguments.out
            << ": planners.yaml (with the best values), table.md, variants.csv\n";
}

/// Clips are in no file that a page is made of.
ReportInputs reportInputs(const Tuning& tuning, std::size_t best) {
  const Arguments& arguments = tuning.arguments;
  const bool has_logs = arguments.collide.empty();
  ReportInputs inputs{arguments.test,       has_logs ? arguments.logs : LogSource(),
                      arguments.background, arguments.jobs,
                      arguments.planner,    comparedVariants(tuning, best)};
  inputs.files.push_back((fs::path(arguments.out) / "test.jsonl").string());
  return inputs;
}

int tune(const Arguments& arguments) {
  StudyConfig config = loadStudyRunConfig(arguments.config);
  usePlannerFile(arguments.planner_file, {arguments.planner}, config.planners);
  const OutputLocks locks = lockFolders({arguments.out, arguments.report});
  const Tuning tuning = openTuning(arguments, config);
  std::vector<PlannerTestResult> train;
  const std::optional<std::size_t> best = agree([&]() -> std::size_t {
    train = driveVariants(tuning);
    return isMaster() ? chooseBest(tuning, train) : 0;
  });
  if (!best) return kExitError;  // the master tells why
  const std::vector<PlannerTestResult> test = compare(tuning, *best);
  if (!isMaster()) return kExitOk;
  report(tuning, *best, train, test);
  if (!arguments.report.empty()) {
    writeReport(reportInputs(tuning, *best), arguments.report, config);
  }
  return kExitOk;
}

/// --train-method and --test-method.
void addAttackers(CLI::App& app, Arguments& arguments, CLI::Option* collide) {
  const auto add = [&](const std::string& name, std::string& method, const std::string& which) {
    app.add_option(name, method,
                   "who attacks in clips that " + which +
                       ", in history mode, hit or miss; by default the suite's own way")
        ->needs(collide);
  };
  add("--train-method", arguments.train_method, "are tuned on");
  add("--test-method", arguments.test_method, "are compared on");
  app.parse_complete_callback([&arguments] {
    for (const auto& [name, method] : {std::pair("--train-method", arguments.train_method),
                                       std::pair("--test-method", arguments.test_method)}) {
      if (!method.empty()) checkMethod(name, method, arguments.config);
    }
  });
}

}  // namespace

void addTune(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app =
      line.add(kPlanners, "tune",
               "Finds the best numbers for a planner; goes on where a run stopped.", [arguments] {
                 if (arguments->grid.empty()) arguments->grid = arguments->config + "/tuning.yaml";
                 return tune(*arguments);
               });
  app.add_option("--planner", arguments->planner, "name")
      ->transform(oneOf(plannerNames()))
      ->capture_default_str();
  addPlannerFile(app, arguments->planner_file);
  app.add_option("--grid", arguments->grid, "values to try (default: tuning.yaml of --config)")
      ->check(CLI::ExistingFile);
  addSource(app, arguments->logs)->required();
  CLI::Option_group* source = app.add_option_group("what is tuned on");
  CLI::Option* train =
      source->add_option("--train", arguments->train, "scenario files of forge generate");
  CLI::Option* test =
      app.add_option("--test", arguments->test, "scenario files of other scenes, to compare on")
          ->needs(train);
  train->needs(test);
  CLI::Option* collide = addCollide(*source, arguments->collide)
                             ->description(
                                 "folder of clips, with trajectory/SPLIT in it; every other scene "
                                 "is tuned on, the rest is compared on");
  source->require_option(1);
  addSplit(app, arguments->split, collide);
  addAttackers(app, *arguments, collide);
  addBackground(app, arguments->background);
  addOut(app, arguments->out, "folder to write; see docs/planners.md");
  addJobs(app, arguments->jobs, "cases at a time, in every rank of mpirun");
  addReportOption(app, arguments->report);
  addConfig(app, arguments->config);
}

}  // namespace forge
