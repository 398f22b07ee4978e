#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "collision_forge/app/options.h"
#include "collision_forge/io/batch/dispatch.h"
#include "collision_forge/io/batch/output.h"
#include "collision_forge/io/logs/log_source.h"
#include "collision_forge/planner_test/report/write_report.h"
#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/planner_test/trials/kept_drives.h"
#include "collision_forge/planner_test/trials/pass_criteria.h"
#include "collision_forge/planner_test/trials/planner_cases.h"
#include "collision_forge/planner_test/trials/planner_run.h"

/// Closed-loop tests of planners, independent of the source of the test cases.
namespace forge {

/// The command-line arguments of a planner test.
struct PlannerTestArguments {
  LogSource logs;
  std::vector<std::string> planners = {"idm", "rule_based", "pdm"};  ///< names of plannerNames()
  OwnPlanners own_planners;
  std::vector<std::string> policies = {"fixed"};  ///< attacker policies: "fixed", "adaptive"
  BackgroundChoice background;                    ///< motion of other agents
  std::size_t worst = 3;                          ///< pictures per planner and policy
  std::string out;                                ///< output folder
  std::string report;                             ///< folder of the HTML report; empty: none
  std::vector<Criterion> criteria;                ///< the planners fail if one of these holds
  std::string junit;                              ///< JUnit XML file; empty: none
  bool steps = false;                             ///< write measures of every step
  ConfigFolder config;
  int jobs = defaultJobs();  ///< threads
};

/// Adds --planners, addOwnPlanners(), --background, --worst, --steps, --out, --jobs, --report,
/// --fail-if, --junit and --config.
void addPlannerTestOptions(CLI::App& app, PlannerTestArguments& arguments);

/// Returns whether any case was tested.
bool anyTested(const std::vector<PlannerTestResult>& results);

/// One run of a planner test. Holds the configuration and the locks of the output folders.
class PlannerTestRun {
 public:
  /// Throws ConfigError, PlannerFileError, and the exceptions of lockFolders().
  explicit PlannerTestRun(PlannerTestArguments arguments);

  /// The configuration, with the user's planners.
  const Config& config() const { return config_; }
  /// Planners, background and policies of the arguments.
  const TestPlan& plan() const { return plan_; }
  /// Path of results.jsonl in the output folder.
  const std::string& resultsPath() const { return results_path_; }

  /// Tests the planners on all cases; resumes an interrupted run. `fingerprints`: inputs of the
  /// results besides configuration, logs, cases and planners. Writes tables and pictures to OUT,
  /// prints the summary and returns the results, without motions. If no case could be tested,
  /// throws std::runtime_error, or returns the results if `may_be_untested`.
  std::vector<PlannerTestResult> run(const PlannerCases& cases,
                                     const ResumableFile::Options& fingerprints = {},
                                     bool may_be_untested = false) const;

  /// Applies the criteria to the results: prints the verdicts, writes the JUnit file. Returns
  /// kExitFailed if a criterion holds, else `code`.
  int judged(const std::vector<PlannerTestResult>& results, int code) const;

  /// Writes the HTML report of the results and of `attacks` (scenario files over `logs`, maps of
  /// sweeps) if --report was given.
  void writePage(const std::vector<std::string>& attacks, const LogSource& logs) const;

 private:
  ResumableFile::Options runOptions(const PlannerCases& cases) const;
  void writeSteps(const PlannerCase& one, const PlannerTestResult& result,
                  const std::vector<std::string>& names) const;
  void writeTables(const std::vector<PlannerTestResult>& results) const;
  void drawWorst(const PlannerCases& cases, const std::vector<PlannerTestResult>& results,
                 const KeptDrives& drives) const;

  const PlannerTestArguments arguments_;
  Config config_;
  const OutputLocks locks_;
  const TestPlan plan_;
  const std::string results_path_;
};

}  // namespace forge
