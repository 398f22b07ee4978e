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
  LogSource logs;  ///< recordings of the cases; only fingerprinted here
  /// Names of plannerNames(), at least one.
  std::vector<std::string> planners = {"idm", "rule_based", "pdm"};
  OwnPlanners own_planners;                       ///< files and commands of the user's planners
  std::vector<std::string> policies = {"fixed"};  ///< attacker policies: "fixed", "adaptive"
  BackgroundChoice background;                    ///< motion of other agents
  /// Number of drawn hits per row (rowKeys()): the most severe fair ones, at most one per scene
  /// (worstCases()); 0: none.
  std::size_t worst = 3;
  std::string out;                  ///< output folder, must not be empty
  std::string report;               ///< folder of the HTML report; empty: none
  std::vector<Criterion> criteria;  ///< --fail-if: the planners fail if one of these holds
  std::string junit;                ///< path of the JUnit XML file; empty: none
  /// Writes OUT/steps/N.csv: measures of every step of case N, from 1 (stepsCsv()).
  bool steps = false;
  ConfigFolder config;
  int jobs = defaultJobs();  ///< threads
};

/// Adds --planners, addOwnPlanners(), --background, --worst, --steps, --out, --jobs, --report,
/// --fail-if, --junit and --config (addConfig()); --out is required, the others are optional. The
/// options reject unknown planners. `arguments` must live until the command has run.
void addPlannerTestOptions(CLI::App& app, PlannerTestArguments& arguments);

/// Returns true if at least one result isTested().
bool anyTested(const std::vector<PlannerTestResult>& results);

/// One run of a planner test. Holds the configuration and the locks of the output folders until its
/// destruction. Not thread-safe.
class PlannerTestRun {
 public:
  /// Loads the configuration, starts the user's planners once (useOwnPlanners()) and locks the
  /// folders `out` and `report`. The names in `arguments` are not checked: run() throws
  /// for an unknown planner, and an unknown policy is undefined behaviour. Throws ConfigError,
  /// PlannerFileError, and the exceptions of lockFolders() and, for the policy "adaptive",
  /// loadPredictionModels().
  explicit PlannerTestRun(PlannerTestArguments arguments);

  /// The configuration, with the user's planners.
  const Config& config() const { return config_; }
  /// Planners, background and policies of the arguments.
  const TestPlan& plan() const { return plan_; }
  /// Path of results.jsonl in the output folder.
  const std::string& resultsPath() const { return results_path_; }

  /// Tests the planners on all cases, at least one; resumes an interrupted run. `fingerprints`:
  /// inputs of the results besides configuration, logs, cases and planners. Writes results.jsonl,
  /// results.csv (plannerResultCsvHeader()), table.csv and table.md (plannerTables()) and pictures
  /// (worst/, named by pictureName()) to OUT, prints the summary and returns one result per case,
  /// in order, without motions. If no case could be tested, writes only results.jsonl and
  /// throws std::runtime_error, or with `may_be_untested` returns the results. Also throws as
  /// testCases(), and std::runtime_error if a file cannot be written.
  std::vector<PlannerTestResult> run(const PlannerCases& cases,
                                     const ResumableFile::Options& fingerprints = {},
                                     bool may_be_untested = false) const;

  /// Applies the criteria of the arguments to the results of run(): prints the verdicts
  /// (verdictText(), nothing without criteria), writes the JUnit file if one was asked for (throws
  /// std::runtime_error if it cannot be written). Returns kExitFailed if a criterion holds for any
  /// row (rowName()), else `code`, the exit code without criteria.
  int applyCriteria(const std::vector<PlannerTestResult>& results, int code) const;

  /// Writes the HTML report of results.jsonl and of the files `attacks` (scenario files over
  /// `logs`, map.png of sweeps) to the folder `report`; does nothing without one. Throws as
  /// writeReport().
  void writePage(const std::vector<std::string>& attacks, const LogSource& logs) const;

 private:
  /// Returns the fingerprints of configuration, logs, cases and planners.
  ResumableFile::Options runOptions(const PlannerCases& cases) const;
  /// Writes OUT/steps/N.csv; N is the position, from 1, of the case in `names` (all cases).
  void writeSteps(const PlannerCase& one, const PlannerTestResult& result,
                  const std::vector<std::string>& names) const;
  /// Writes results.csv, table.csv and table.md.
  void writeTables(const std::vector<PlannerTestResult>& results) const;
  /// Draws the hardest hits of each row into OUT/worst, which is emptied first.
  void drawWorst(const PlannerCases& cases, const std::vector<PlannerTestResult>& results,
                 const KeptDrives& drives) const;

  const PlannerTestArguments arguments_;
  Config config_;
  const OutputLocks locks_;
  const TestPlan plan_;
  const std::string results_path_;
};

}  // namespace forge
