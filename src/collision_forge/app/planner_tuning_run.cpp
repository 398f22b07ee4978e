#include "collision_forge/app/planner_tuning_run.h"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/app/report.h"
#include "collision_forge/base/config/config_file.h"
#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/base/files/fingerprint.h"
#include "collision_forge/base/scene/number_words.h"
#include "collision_forge/io/batch/output.h"
#include "collision_forge/planner_test/planners/planner_factory.h"
#include "collision_forge/planner_test/settings/config_fingerprint.h"
#include "collision_forge/planner_test/trials/planner_report.h"
#include "collision_forge/planner_test/trials/planner_run.h"
#include "collision_forge/planner_test/trials/planner_tuning.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

/// The planners.yaml whose values are tuned.
struct PlannersFile {
  std::string path = "planners.yaml";
  std::string text;
};

/// The inputs of a tuning run.
struct Tuning {
  const TuningArguments& arguments;
  const Config& config;
  const PlannersFile file;
  const std::vector<PlannerVariant> variants;
  const TuningCases cases;
};

Tuning openTuning(const TuningArguments& arguments, const Config& config, TuningCases cases) {
  const PlannersFile file{"planners.yaml", arguments.config.text("planners.yaml")};
  const PlannerGrid grid =
      arguments.grid.empty()
          ? readPlannerGrid(openConfigFile(arguments.config, "tuning.yaml"), arguments.planner)
          : readPlannerGrid(arguments.grid, arguments.planner);
  std::vector<PlannerVariant> variants =
      variantsOf(grid, file.path, file.text, config.attack.verification.limits);
  for (PlannerVariant& variant : variants) {
    variant.options.torchscript.file = config.planners.torchscript.file;
    variant.options.torchscript.workers = config.planners.torchscript.workers;
    variant.options.traffic_model = config.planners.traffic_model;
    variant.options.external.command = config.planners.external.command;
    variant.options.external.is_node = config.planners.external.is_node;
    variant.options.external.processes = config.planners.external.processes;
  }
  return {arguments, config, file, std::move(variants), std::move(cases)};
}

/// Returns the fingerprints of all inputs of training and test results.
ResumableFile::Options runOptions(const Tuning& tuning) {
  const TuningArguments& arguments = tuning.arguments;
  ResumableFile::Options options = inputsOf(tuning.config, arguments.logs);
  options["planner"] = arguments.planner;
  addPlannerFingerprints(options, {arguments.planner}, tuning.config.planners);
  addBackgroundFingerprints(options, arguments.background);
  std::string found;
  for (const PlannerVariant& variant : tuning.variants) {
    for (const auto& [key, value] : variant.values) {
      found = fingerprint(key + "=" + shortestText(value) + ";", found);
    }
  }
  options["grid"] = std::to_string(tuning.variants.size()) + " variants, fingerprint " + found;
  for (const auto& [name, value] : tuning.cases.fingerprints) options[name] = value;
  options["train"] = tuning.cases.train->fingerprint();
  return options;
}

/// Returns the run that writes OUT/NAME.jsonl.
Run partRun(const Tuning& tuning, const std::string& name, const PlannerCases& cases) {
  Run run;
  run.path = (fs::path(tuning.arguments.out) / (name + ".jsonl")).string();
  run.options = runOptions(tuning);
  run.options[name] = cases.fingerprint();
  run.jobs = tuning.arguments.jobs;
  return run;
}

/// Tests every variant on the training cases and returns the results.
std::vector<PlannerTestResult> driveVariants(const Tuning& tuning) {
  return testCases(partRun(tuning, "train", *tuning.cases.train), *tuning.cases.train,
                   [&](const PlannerCase& one) {
                     return testVariants(one, tuning.arguments.planner, tuning.variants, true,
                                         tuning.arguments.background.backgrounds.front(),
                                         tuning.config, tuning.config.planners);
                   });
}

/// Returns the default and the best variant, named "tuned".
std::vector<PlannerVariant> comparedVariants(const Tuning& tuning, std::size_t best) {
  std::vector<PlannerVariant> pair = {tuning.variants.front(), tuning.variants[best]};
  pair.back().name = "tuned";
  return pair;
}

/// Tests default and tuned planner on the test cases and returns the results.
std::vector<PlannerTestResult> compare(const Tuning& tuning, std::size_t best) {
  const std::vector<PlannerVariant> pair = comparedVariants(tuning, best);
  return testCases(partRun(tuning, "test", *tuning.cases.test), *tuning.cases.test,
                   [&](const PlannerCase& one) {
                     return testVariants(one, tuning.arguments.planner, pair, false,
                                         tuning.arguments.background.backgrounds.front(),
                                         tuning.config, tuning.config.planners);
                   });
}

/// Returns the index of the best variant and writes the scores of all to variants.csv.
std::size_t chooseBest(const Tuning& tuning, const std::vector<PlannerTestResult>& results) {
  const auto scores = scoreVariants(results, tuning.variants);
  const auto best = bestVariant(scores);
  if (!best) {
    throw std::runtime_error("the training scenarios contain no avoidable collision to tune on");
  }
  writeText(tuning.arguments.out + "/variants.csv", scoresCsv(tuning.variants, scores, *best));
  return *best;
}

void report(const Tuning& tuning, std::size_t best, const std::vector<PlannerTestResult>& train,
            const std::vector<PlannerTestResult>& test) {
  const TuningArguments& arguments = tuning.arguments;
  const PlannerValues& before = tuning.variants.front().values;
  const PlannerValues& after = tuning.variants[best].values;
  const RateTable comparison = comparisonTable(test);
  const std::string outcome = reportTitle("Tuning of " + arguments.planner) + "\nBest of " +
                              counted(tuning.variants.size(), "variant") +
                              " on the training scenarios (" + tuning.variants[best].name +
                              " of variants.csv):\n\n" + describeValues(before, after) +
                              "\nTraining: " + describeCases(train) +
                              "\nTest: " + describeCases(test) + "\n" + toMarkdown(comparison);
  std::string text = outcome;
  std::string csv = rateCsvHeader() + "\n" + toCsv(comparison);
  const Background background = arguments.background.backgrounds.front();
  const std::vector<std::string> rows = {rowName(RowKey{"default", PolicyKind::kFixed, background}),
                                         rowName(RowKey{"tuned", PolicyKind::kFixed, background})};
  for (const PlannerTable& entry : plannerTables(test, rows)) {
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

ReportInputs reportInputs(const Tuning& tuning) {
  const TuningArguments& arguments = tuning.arguments;
  const std::vector<std::string>& files = tuning.cases.test_files;
  ReportInputs inputs{files, files.empty() ? LogSource() : arguments.logs};
  inputs.files.push_back((fs::path(arguments.out) / "test.jsonl").string());
  return inputs;
}

}  // namespace

int tunePlanner(const TuningArguments& arguments,
                const std::function<TuningCases(const Config&)>& open) {
  Config config = loadConfig(arguments.config);
  useOwnPlanners(arguments.own_planners, {arguments.planner}, config);
  useBackground(arguments.background, config);
  const OutputLocks locks = lockFolders({arguments.out, arguments.report});
  const Tuning tuning = openTuning(arguments, config, open(config));
  const std::vector<PlannerTestResult> train = driveVariants(tuning);
  const std::size_t best = chooseBest(tuning, train);
  const std::vector<PlannerTestResult> test = compare(tuning, best);
  report(tuning, best, train, test);
  if (!arguments.report.empty()) {
    writeReport(reportInputs(tuning), arguments.report, config);
  }
  return kExitOk;
}

void addTuningOptions(CLI::App& app, TuningArguments& arguments) {
  app.add_option("--planner", arguments.planner, "planner to tune")
      ->transform(oneOf(plannerNames()))
      ->capture_default_str();
  addOwnPlanners(app, arguments.own_planners);
  app.add_option("--grid", arguments.grid,
                 "YAML file with the values to try (default: tuning.yaml of --config)")
      ->check(CLI::ExistingFile);
  addSource(app, arguments.logs)->required();
  addBackground(app, arguments.background, 1);
  addOut(app, arguments.out, "output folder; see docs/planners.md");
  addJobs(app, arguments.jobs, "cases tested in parallel");
  addReportOption(app, arguments.report);
  addConfig(app, arguments.config);
}

}  // namespace forge
