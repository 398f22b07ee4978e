#include "collision_forge/app/planner_test_run.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/app/planner_pictures.h"
#include "collision_forge/app/report.h"
#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/base/scene/number_words.h"
#include "collision_forge/io/batch/output.h"
#include "collision_forge/io/weights/pattern_network_file.h"
#include "collision_forge/planner_test/planners/planner_factory.h"
#include "collision_forge/planner_test/report/junit_file.h"
#include "collision_forge/planner_test/statistics/rate_table.h"
#include "collision_forge/planner_test/trials/kept_drives.h"
#include "collision_forge/planner_test/trials/planner_report.h"
#include "collision_forge/planner_test/trials/planner_result_file.h"
#include "collision_forge/planner_test/trials/planner_summary.h"
#include "collision_forge/planner_test/trials/step_metrics.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ",") + word;
  return text;
}

/// Sums the computing time of the planners in this process, by rowName(). Thread-safe add().
class PlanningTimes {
 public:
  void add(const PlannerTestResult& result) {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const PlannerRow& row : result.rows) {
      Sum& sum = sums_[rowName(row)];
      sum.seconds += row.outcome.planning_seconds;
      sum.calls += row.outcome.plans;
    }
  }

  /// Returns the mean ms per call of each planner that was called at least once.
  std::map<std::string, double> means() const {
    std::map<std::string, double> found;
    for (const auto& [row, sum] : sums_) {
      if (sum.calls > 0) found[row] = 1e3 * sum.seconds / static_cast<double>(sum.calls);
    }
    return found;
  }

 private:
  struct Sum {
    double seconds = 0.0;
    long calls = 0;
  };
  std::mutex mutex_;
  std::map<std::string, Sum> sums_;
};

std::string csvOf(const std::vector<PlannerTestResult>& results) {
  std::string text = plannerResultCsvHeader() + "\n";
  for (const PlannerTestResult& result : results) {
    for (const std::string& row : plannerResultCsvRows(result)) text += row + "\n";
  }
  return text;
}

TestPlan planOf(const PlannerTestArguments& arguments, const Config& config) {
  TestPlan plan{arguments.planners, arguments.background.backgrounds, {}, {}};
  for (const std::string& name : arguments.policies) {
    plan.policies.push_back(*policyKindFromString(name));
    if (plan.policies.back() == PolicyKind::kAdaptive) plan.models = loadPredictionModels(config);
  }
  return plan;
}

Config loadTestConfig(const PlannerTestArguments& arguments) {
  Config config = loadConfig(arguments.config);
  useOwnPlanners(arguments.own_planners, arguments.planners, config);
  useBackground(arguments.background, config);
  return config;
}

/// Prints the rates of each planner and the names of the output files.
void printSummary(const std::vector<PlannerTestResult>& results, const PlanningTimes& times,
                  const TestPlan& plan, const std::string& folder) {
  const auto is_tested = [](const PlannerTestResult& result) { return result.isTested(); };
  const auto tested = std::count_if(results.begin(), results.end(), is_tested);
  std::cout << tested << " of " << counted(results.size(), "case") << " tested\n"
            << summaryText(summarizePlanners(results, rowNames(plan)), times.means())
            << backgroundText(results, plan) << "in " << folder
            << ": table.md (rates by type and TTA, reasons of untested cases), results.csv, worst/ "
               "(pictures)\n";
}

/// --fail-if.
void addCriteria(CLI::App& app, std::vector<Criterion>& criteria) {
  std::string text =
      "criterion under which a planner fails the test, such as 'avoidable_hits > 0', or @FILE with "
      "one per line; repeatable; exit code 4. Measures:";
  for (const std::string& measure : measureDescriptions()) text += "\n" + measure;
  const auto add = [&criteria](const std::vector<std::string>& given) {
    for (const std::string& one : given) {
      try {
        for (Criterion& criterion : parseCriteria(one)) criteria.push_back(std::move(criterion));
      } catch (const std::invalid_argument& error) {
        throw CLI::ValidationError("--fail-if", error.what());
      }
    }
  };
  app.add_option_function<std::vector<std::string>>("--fail-if", add, text)->expected(1, -1);
}

/// Throws std::runtime_error that no case was tested.
void refuseUntested(const std::vector<PlannerTestResult>& results, const std::string& path) {
  const PlannerTestResult& first = results.front();
  throw std::runtime_error(path + ": no case could be tested (" + std::to_string(results.size()) +
                           " tried); the first one, " + first.name + ": " + first.status + ": " +
                           first.message);
}

}  // namespace

bool anyTested(const std::vector<PlannerTestResult>& results) {
  return std::any_of(results.begin(), results.end(),
                     [](const PlannerTestResult& result) { return result.isTested(); });
}

PlannerTestRun::PlannerTestRun(PlannerTestArguments arguments)
    : arguments_(std::move(arguments)),
      config_(loadTestConfig(arguments_)),
      locks_(lockFolders({arguments_.out, arguments_.report})),
      plan_(planOf(arguments_, config_)),
      results_path_((fs::path(arguments_.out) / "results.jsonl").string()) {}

ResumableFile::Options PlannerTestRun::runOptions(const PlannerCases& cases) const {
  ResumableFile::Options options = inputsOf(config_, arguments_.logs);
  options["cases"] = cases.fingerprint();
  options["planners"] = joined(arguments_.planners);
  options["attacker_policy"] = joined(arguments_.policies);
  addPlannerFingerprints(options, arguments_.planners, config_.planners);
  addBackgroundFingerprints(options, arguments_.background);
  if (arguments_.steps) options["steps"] = "true";
  return options;
}

void PlannerTestRun::writeTables(const std::vector<PlannerTestResult>& results) const {
  std::string text = reportTitle("Planners in closed loop") + "\n" + describeCases(results) +
                     backgroundText(results, plan_);
  std::string csv = rateCsvHeader() + "\n";
  for (const PlannerTable& entry : plannerTables(results, rowNames(plan_))) {
    text += "\n" + toMarkdown(entry.table, entry.unit);
    csv += toCsv(entry.table);
  }
  writeText(arguments_.out + "/results.csv", csvOf(results));
  writeText(arguments_.out + "/table.csv", csv);
  writeText(arguments_.out + "/table.md", text);
}

void PlannerTestRun::drawWorst(const PlannerCases& cases,
                               const std::vector<PlannerTestResult>& results,
                               const KeptDrives& drives) const {
  const fs::path folder = fs::path(arguments_.out) / "worst";
  fs::remove_all(folder);
  fs::create_directories(folder);
  for (const RowKey& key : rowKeys(plan_)) {
    int rank = 0;
    for (const WorstCase& worst : worstCases(results, {rowName(key)}, arguments_.worst)) {
      const PlannerCase one = cases.at(worst.result);
      drawView((folder / pictureName(key, ++rank)).string(),
               viewOfCollision(one, drives.rowOf(one, worst.result, key), config_),
               config_.drawing);
    }
  }
}

/// Called for every case before its line is kept, so a resumed run has the files of all cases.
void PlannerTestRun::writeSteps(const PlannerCase& one, const PlannerTestResult& result,
                                const std::vector<std::string>& names) const {
  const auto place = std::find(names.begin(), names.end(), one.name) - names.begin();
  const fs::path folder = fs::path(arguments_.out) / "steps";
  writeText((folder / (std::to_string(place + 1) + ".csv")).string(), stepsCsv(one, result));
}

std::vector<PlannerTestResult> PlannerTestRun::run(const PlannerCases& cases,
                                                   const ResumableFile::Options& fingerprints,
                                                   bool may_be_untested) const {
  Run run;
  run.path = results_path_;
  run.options = runOptions(cases);
  run.options.insert(fingerprints.begin(), fingerprints.end());
  run.jobs = arguments_.jobs;
  PlanningTimes times;
  if (arguments_.steps) fs::create_directories(fs::path(arguments_.out) / "steps");
  const auto test = [&](const PlannerCase& one) {
    const PlannerTestResult result = testPlanners(one, plan_, config_, config_.planners);
    times.add(result);
    if (arguments_.steps) writeSteps(one, result, cases.names());
    return result;
  };
  std::vector<PlannerTestResult> results = testCases(run, cases, test);
  if (!anyTested(results)) {
    if (!may_be_untested) refuseUntested(results, run.path);
    return results;
  }
  writeTables(results);
  printSummary(results, times, plan_, arguments_.out);
  drawWorst(cases, results, KeptDrives(results_path_));
  return results;
}

int PlannerTestRun::applyCriteria(const std::vector<PlannerTestResult>& results, int code) const {
  const std::vector<std::string> rows = rowNames(plan_);
  const std::vector<CriterionVerdict> verdicts = judge(arguments_.criteria, results, rows);
  std::cout << verdictText(verdicts);
  if (!arguments_.junit.empty()) {
    writeText(arguments_.junit, junitText(results, arguments_.criteria, verdicts, rows));
  }
  const auto is_failed = [](const CriterionVerdict& verdict) { return verdict.is_failed; };
  return std::any_of(verdicts.begin(), verdicts.end(), is_failed) ? kExitFailed : code;
}

void PlannerTestRun::writePage(const std::vector<std::string>& attacks,
                               const LogSource& logs) const {
  if (arguments_.report.empty()) return;
  ReportInputs inputs{attacks, logs};
  inputs.files.push_back(results_path_);
  writeReport(inputs, arguments_.report, config_);
}

void addPlannerTestOptions(CLI::App& app, PlannerTestArguments& arguments) {
  app.add_option("--planners", arguments.planners, "planners to test, separated by commas")
      ->delimiter(',')
      ->transform(oneOf(plannerNames()))
      ->capture_default_str();
  addOwnPlanners(app, arguments.own_planners);
  addBackground(app, arguments.background, 3);
  app.add_option("--worst", arguments.worst,
                 "number of pictures per planner, hardest impacts first")
      ->capture_default_str();
  app.add_flag("--steps", arguments.steps,
               "also write OUT/steps/N.csv: measures of every step of all rollouts of case N");
  addOut(app, arguments.out, "output folder; see docs/planners.md");
  addJobs(app, arguments.jobs, "cases tested in parallel");
  addReportOption(app, arguments.report);
  addCriteria(app, arguments.criteria);
  app.add_option("--junit", arguments.junit,
                 "JUnit XML file; a case fails if it is counted by a measure of --fail-if");
  addConfig(app, arguments.config);
}

}  // namespace forge
