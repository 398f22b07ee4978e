#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/evaluation.h"
#include "collision_forge/app/options.h"
#include "collision_forge/app/planner_pictures.h"
#include "collision_forge/app/report.h"
#include "collision_forge/app/run_config.h"
#include "collision_forge/app/until_hit.h"
#include "collision_forge/batch/dispatch.h"
#include "collision_forge/batch/output.h"
#include "collision_forge/batch/progress_line.h"
#include "collision_forge/data/collide_set.h"
#include "collision_forge/data/pattern_network_file.h"
#include "collision_forge/files/aside_file.h"
#include "collision_forge/planners/planner_factory.h"
#include "collision_forge/scene/number_words.h"
#include "collision_forge/settings/config_fingerprint.h"
#include "collision_forge/study/clip_cases.h"
#include "collision_forge/trials/planner_cases.h"
#include "collision_forge/trials/planner_report.h"
#include "collision_forge/trials/planner_result_file.h"
#include "collision_forge/trials/planner_run.h"
#include "collision_forge/trials/planner_summary.h"
#include "collision_forge/trials/request_cases.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  LogSource logs;
  std::vector<std::string> scenarios;
  bool until_hit = false;
  std::vector<std::string> scenes;
  std::optional<std::size_t> tries;
  std::uint64_t seed = 0;
  std::string collide;
  std::string split = "val";
  ClipAttacker attacker = ClipAttacker::kRecorded;
  bool unverified = false;
  std::size_t limit = 0;
  std::vector<std::string> planners = {"idm", "rule_based", "pdm"};
  std::string planner_file;
  std::vector<std::string> policies;  ///< empty: adaptive with until_hit, else fixed
  Background background = Background::kReplay;
  std::size_t worst = 3;
  std::string out;
  std::string report;
  std::string config;
  std::string method;
  int jobs = defaultJobs();
};

/// Collisions that can be asked for in scenes. They come in no order of the scenes.
struct DrawnCases {
  static constexpr std::size_t kScenesKept = 64;

  DrawnCases(const Arguments& arguments, const StudyConfig& config)
      : scenes(arguments.logs, arguments.scenes, config, kScenesKept, {}, showReading()),
        requests(scenes, loadMethod(arguments.method, config, config.attack), config,
                 {config.requests, arguments.tries.value_or(config.planners.until_hit.tries),
                  arguments.seed, [this](std::size_t done, std::size_t count) {
                    if (isMaster()) progress.show(done, count);
                  }}) {}

  ProgressLine progress{"scenes"};
  SceneSource scenes;
  RequestCases requests;
};

std::unique_ptr<PlannerCases> openCases(const Arguments& arguments, const StudyConfig& config) {
  if (arguments.collide.empty()) {
    return openScenarioCases(arguments.scenarios, arguments.logs,
                             static_cast<std::size_t>(arguments.jobs) + 1, config, showReading());
  }
  std::vector<std::string> paths = listCollideClips(arguments.collide, arguments.split);
  if (arguments.limit > 0 && arguments.limit < paths.size()) paths.resize(arguments.limit);
  return openClipCases(paths, arguments.logs.path, arguments.attacker, arguments.method,
                       arguments.unverified ? ClipAnswers::kAll : ClipAnswers::kVerified, config);
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ",") + word;
  return text;
}

/// What the results depend on.
ResumableFile::Options runOptions(const Arguments& arguments, const PlannerCases& cases,
                                  const StudyConfig& config) {
  ResumableFile::Options options = inputsOf(config, arguments.config, arguments.logs);
  options["cases"] = cases.fingerprint();
  options["planners"] = joined(arguments.planners);
  options["attacker_policy"] = joined(arguments.policies);
  addPlannerFingerprint(options, arguments.planners, config.planners);
  options["background"] = arguments.background == Background::kIdm ? "idm" : "replay";
  return options;
}

/// How long the planners computed in this process, by rowName().
class PlanningTimes {
 public:
  void add(const PlannerTestResult& result) {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const PlannerRow& row : result.rows) {
      Sum& sum = sums_[rowName(row.planner, row.attacker.policy)];
      sum.seconds += row.outcome.planning_seconds;
      sum.calls += row.outcome.plans;
    }
  }

  /// Milliseconds a call in the mean, of those that were called.
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

TestPlan planOf(const Arguments& arguments, const StudyConfig& config) {
  TestPlan plan{arguments.planners, arguments.background, {}, {}};
  for (const std::string& name : arguments.policies) {
    plan.policies.push_back(*policyKindFromString(name));
    if (plan.policies.back() == PolicyKind::kAdaptive) plan.foresight = loadForesight(config);
  }
  return plan;
}

/// Writes what the results say into files.
void writeTables(const std::vector<PlannerTestResult>& results, const Arguments& arguments,
                 const TestPlan& plan, const StudyConfig& config) {
  const StatisticsOptions& statistics = config.evaluation.statistics;
  std::string text =
      reportTitle("Planners in closed loop", statistics) + "\n" + describeCases(results);
  std::string csv = rateCsvHeader() + "\n";
  for (const PlannerTable& entry : plannerTables(results, rowNames(plan), statistics)) {
    text += "\n" + toMarkdown(entry.table, entry.unit);
    csv += toCsv(entry.table);
  }
  writeText(arguments.out + "/results.csv", csvOf(results));
  writeText(arguments.out + "/table.csv", csv);
  writeText(arguments.out + "/table.md", text);
}

/// Prints how each planner did, and where more is.
void printSummary(const std::vector<PlannerTestResult>& results, const PlanningTimes& times,
                  const TestPlan& plan, const std::string& folder) {
  const auto is_tested = [](const PlannerTestResult& result) { return result.isTested(); };
  const auto tested = std::count_if(results.begin(), results.end(), is_tested);
  std::cout << tested << " of " << counted(results.size(), "case") << " tested\n"
            << summaryText(summarizePlanners(results, rowNames(plan)), times.means()) << "in "
            << folder
            << ": table.md (rates by type and time, and why cases were not tested), results.csv, "
               "worst/ (pictures)\n";
}

void drawWorst(const PlannerCases& cases, const std::vector<PlannerTestResult>& results,
               const Arguments& arguments, const TestPlan& plan, const StudyConfig& config) {
  const fs::path folder = fs::path(arguments.out) / "worst";
  fs::remove_all(folder);
  fs::create_directories(folder);
  std::map<std::string, int> ranks;
  for (const std::string& planner : plan.planners) {
    for (const PolicyKind policy : plan.policies) {
      const std::string row = rowName(planner, policy);
      for (const WorstCase& worst : worstCases(results, {row}, arguments.worst)) {
        const PlannerCase one = cases.at(worst.result);
        const std::string name =
            planner + "_" + toString(policy) + "_" + std::to_string(++ranks[row]);
        const RolloutOutcome outcome =
            driveAgain(one, planner, policy, plan, config, config.planners);
        if (!outcome.contact) continue;  // of a planner that is timed by the wall clock
        drawView((folder / name).string(), viewOfHit(one, planner, policy, outcome, config),
                 config.drawing);
      }
    }
  }
}

/// Throws where there is nothing to report on.
void checkTested(const std::vector<PlannerTestResult>& results, const std::string& path) {
  const auto isTested = [](const PlannerTestResult& result) { return result.isTested(); };
  if (std::any_of(results.begin(), results.end(), isTested)) return;
  const PlannerTestResult& first = results.front();
  throw std::runtime_error(path + ": none of the cases could be tested (" +
                           std::to_string(results.size()) + "); the first, " + first.name + ": " +
                           first.status + ": " + first.message);
}

/// Of a draw the attacks behind the weaknesses; clips are in no file that a page is made of.
ReportInputs reportInputs(const Arguments& arguments, const std::string& results) {
  ReportInputs inputs{arguments.scenarios, {}, arguments.background, arguments.jobs};
  const std::string weaknesses = arguments.out + "/weaknesses.jsonl";
  if (arguments.until_hit && fs::file_size(weaknesses) > 0) inputs.files.push_back(weaknesses);
  if (!inputs.files.empty()) inputs.logs = arguments.logs;
  inputs.files.push_back(results);
  return inputs;
}

int drive(Arguments arguments) {
  if (arguments.policies.empty()) {
    arguments.policies = {arguments.until_hit ? "adaptive" : "fixed"};
  }
  StudyConfig config = loadStudyRunConfig(arguments.config);
  usePlannerFile(arguments.planner_file, arguments.planners, config.planners);
  const OutputLocks locks = lockFolders({arguments.out, arguments.report});
  std::optional<DrawnCases> drawn;
  std::unique_ptr<PlannerCases> given;
  if (arguments.until_hit) {
    drawn.emplace(arguments, config);
  } else {
    given = openCases(arguments, config);
  }
  const PlannerCases& cases = drawn ? drawn->requests : *given;
  Run run;
  run.path = (fs::path(arguments.out) / "results.jsonl").string();
  run.options = runOptions(arguments, cases, config);
  run.jobs = arguments.jobs;
  PlanningTimes times;
  const TestPlan plan = planOf(arguments, config);
  const auto test = [&](const PlannerCase& one) {
    const PlannerTestResult result = testPlanners(one, plan, config, config.planners);
    times.add(result);
    return result;
  };
  const std::vector<PlannerTestResult> results = testCases(run, cases, test);
  if (!isMaster()) return kExitOk;
  checkTested(results, run.path);
  writeTables(results, arguments, plan, config);
  printSummary(results, times, plan, arguments.out);
  drawWorst(cases, results, arguments, plan, config);
  if (drawn) reportWeaknesses(drawn->requests, results, plan, arguments.out, config);
  if (!arguments.report.empty()) {
    writeReport(reportInputs(arguments, run.path), arguments.report, config);
  }
  return kExitOk;
}

}  // namespace

void addTest(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app =
      line.add(kPlanners, "test", "Drives planners through crashes; goes on where a run stopped.",
               [arguments] { return drive(*arguments); });
  addSource(app, arguments->logs)->required();
  CLI::Option_group* source = app.add_option_group("what they are driven through");
  source->add_option("--scenarios", arguments->scenarios, "scenario files of forge generate");
  CLI::Option* until_hit =
      source->add_flag("--until-hit", arguments->until_hit,
                       "collisions drawn from all that can be asked for in scenes; writes the "
                       "planners' weaknesses, the worst first");
  addScenes(app, arguments->scenes)->needs(until_hit);
  app.add_option("--tries", arguments->tries, "collisions that are tried; see planners.yaml")
      ->check(CLI::PositiveNumber)
      ->needs(until_hit);
  addSeed(app, arguments->seed, "of the draw of --until-hit")->needs(until_hit);
  CLI::Option* collide = addCollide(*source, arguments->collide);
  source->require_option(1);
  addSplit(app, arguments->split, collide);
  addLimit(app, arguments->limit, collide);
  addChoice<ClipAttacker>(app, "--drive", arguments->attacker,
                          {{"recorded", ClipAttacker::kRecorded},
                           {"history", ClipAttacker::kHistory},
                           {"replay", ClipAttacker::kReplay}},
                          "who attacks in clips: the set's own attacker as recorded, or that of "
                          "--method in history or replay mode")
      ->needs(collide);
  app.add_flag("--unverified", arguments->unverified,
               "attackers of --method as forge evaluate judges them, whether or not the crash is "
               "as asked; by default those alone that are")
      ->needs(collide);
  addMethod(app, arguments->method, arguments->config)->excludes(source->get_option("--scenarios"));
  app.add_option("--planners", arguments->planners, "names, separated by commas")
      ->delimiter(',')
      ->transform(oneOf(plannerNames()))
      ->capture_default_str();
  app.add_option("--attacker-policy", arguments->policies,
                 "who drives the attacker, separated by commas: fixed, its trajectory as it is; "
                 "adaptive, one that sees the ego and plans anew, not with --collide; by default "
                 "adaptive with --until-hit, else fixed")
      ->delimiter(',')
      ->transform(oneOf({"fixed", "adaptive"}))
      ->excludes(collide);
  addPlannerFile(app, arguments->planner_file);
  addBackground(app, arguments->background);
  app.add_option("--worst", arguments->worst, "pictures a planner, of the hardest impacts")
      ->capture_default_str();
  addOut(app, arguments->out, "folder to write; see docs/planners.md");
  addJobs(app, arguments->jobs, "cases at a time, in every rank of mpirun");
  addReportOption(app, arguments->report);
  addConfig(app, arguments->config);
}

}  // namespace forge
