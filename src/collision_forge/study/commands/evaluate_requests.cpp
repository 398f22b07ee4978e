#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <map>
#include <mutex>
#include <numeric>
#include <set>
#include <utility>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/app/report.h"
#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/io/batch/dispatch.h"
#include "collision_forge/io/batch/output.h"
#include "collision_forge/io/scenarios/request_file.h"
#include "collision_forge/io/weights/pattern_network_file.h"
#include "collision_forge/planner_test/settings/config_fingerprint.h"
#include "collision_forge/study/commands/evaluation.h"
#include "collision_forge/study/commands/study_commands.h"
#include "collision_forge/study/commands/study_run_config.h"
#include "collision_forge/study/evaluation/motion_table.h"
#include "collision_forge/study/evaluation/report_rows.h"
#include "collision_forge/study/evaluation/request_evaluation.h"
#include "collision_forge/study/evaluation/request_report.h"
#include "collision_forge/study/evaluation/study_program.h"

namespace forge {
namespace {

/// The requests of the selected scenes.
struct WantedRequests {
  std::vector<SceneRequest> requests;
  std::vector<std::string> lines;   ///< line of each request in the list, from 1
  std::vector<std::string> scenes;  ///< names, in order of first use
};

WantedRequests readWanted(const EvaluationArguments& arguments, const StudyConfig& config) {
  const auto names = readSceneNames(arguments.logs);
  const std::set<std::string> known(names.begin(), names.end());
  const auto chosen = wantedScenes(arguments.logs, arguments.scenes);
  const std::set<std::string> scenes(chosen.begin(), chosen.end());
  WantedRequests wanted;
  std::set<std::string> seen;
  std::size_t line = 0;
  for (SceneRequest& request :
       readRequests(arguments.requests, known, config.input_limits, config.crash)) {
    ++line;
    if (scenes.count(request.scene) == 0) continue;
    if (seen.insert(request.scene).second) wanted.scenes.push_back(request.scene);
    wanted.requests.push_back(std::move(request));
    wanted.lines.push_back(std::to_string(line));
  }
  if (wanted.requests.empty()) {
    throw std::runtime_error(arguments.requests + ": contains no request for the given --scene");
  }
  return wanted;
}

/// Returns the plan; options that the command line omits are taken from the configuration.
EvaluationPlan planOf(const EvaluationArguments& arguments, const StudyConfig& config) {
  EvaluationPlan plan = arguments.plan;
  plan.limits = arguments.limits.value_or(config.crash.limits);
  plan.believable = arguments.believable.value_or(config.crash.believable);
  return plan;
}

ResumableFile::Options runOptions(const EvaluationArguments& arguments, const StudyConfig& config,
                                  const EvaluationPlan& plan, const WantedRequests& wanted) {
  ResumableFile::Options options = studyInputsOf(config, arguments.logs);
  options["requests"] = fingerprintOf(wanted.requests);
  options["method"] = plan.method;
  options["mode"] = toString(plan.mode);
  options["seeds"] = std::to_string(plan.seeds);
  options["limits"] = toString(plan.limits);
  options["believable"] = plan.believable ? "yes" : "no";
  return options;
}

/// Collects the ms per request, or per update step of an adaptive attacker, by method. add() is
/// thread-safe.
class SearchTimes {
 public:
  void add(const std::vector<SearchTime>& times) {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const SearchTime& time : times) times_[time.method].push_back(time.milliseconds);
  }

  void print() {
    for (auto& [method, times] : times_) {
      std::sort(times.begin(), times.end());
      const double mean = std::accumulate(times.begin(), times.end(), 0.0) / times.size();
      std::printf(
          "%s: mean %.1f ms on one core, median %.1f ms, 95 %% quantile %.1f ms (%zu measurements "
          "in this process)\n",
          method.c_str(), mean, quantile(times, 0.5), quantile(times, 0.95), times.size());
    }
  }

 private:
  std::mutex mutex_;
  std::map<std::string, std::vector<double>> times_;
};

/// Returns the title of the charts: logs and number of requests.
std::string headline(const std::string& logs, const WantedRequests& wanted) {
  return logs + ", " + std::to_string(wanted.requests.size()) + " requests";
}

/// Returns the title of the tables: logs, protocol, limits, mode and number of requests.
std::string headline(const std::string& logs, const EvaluationPlan& plan,
                     const WantedRequests& wanted) {
  return logs + ", strict protocol, " + toString(plan.limits) + " limits" +
         (plan.believable ? ", plausible" : "") + ", " + toString(plan.mode) + " mode, " +
         std::to_string(wanted.requests.size()) + " requests of " +
         std::to_string(wanted.scenes.size()) + " scenes";
}

void report(const EvaluationArguments& arguments, const EvaluationPlan& plan,
            const std::vector<ResultRow>& rows, const WantedRequests& wanted) {
  const std::string title = headline(arguments.logs.title(), plan, wanted);
  const std::string short_title = headline(arguments.logs.title(), wanted);
  std::string text = reportTitle(title);
  const std::vector<RateTable> tables = requestTables(rows, plan);
  for (const RateTable& table : tables) text += "\n" + toMarkdown(table);
  std::vector<std::string> charts = writeRates(tables, short_title, arguments.out);
  const auto calibrations = requestCalibrations(rows, plan);
  for (const Calibration& calibration : calibrations) text += "\n" + toMarkdown(calibration);
  if (!calibrations.empty()) {
    const std::string path = arguments.out + "/calibration.csv";
    writeText(path, toCsv(calibrations));
    charts.insert(charts.end(), {"--calibration", path});
  }
  writeText(arguments.out + "/table.md", text);
  std::cout << text << std::endl;
  runStudyProgram("charts.py", charts);
}

/// Writes the scorecard, which compares the attackers with the recorded vehicles of the same
/// scenes.
void writeScorecard(const EvaluationArguments& arguments, const EvaluationPlan& plan,
                    const StudyConfig& config, const std::vector<ResultRow>& rows,
                    const WantedRequests& wanted, SceneSource& scenes) {
  const std::vector<std::string> methods = attackingRowMethods(plan);
  if (methods.empty()) return;
  std::vector<RecordedMotion> recorded;
  for (const std::string& scene : wanted.scenes) {
    for (RecordedMotion& motion : recordedMotion(*scenes.at(scene), config)) {
      recorded.push_back(std::move(motion));
    }
  }
  writeText(arguments.out + "/motion.csv", motionTable(rows, methods, recorded, config));
  const StatisticsOptions statistics;
  const std::string title = headline(arguments.logs.title(), plan, wanted);
  runStudyProgram("scorecard.py", {arguments.out, "--heading", reportTitle(title), "--title",
                                   headline(arguments.logs.title(), wanted), "--resamples",
                                   std::to_string(statistics.resamples), "--confidence",
                                   std::to_string(statistics.confidence), "--seed",
                                   std::to_string(statistics.seed)});
}

}  // namespace

int evaluateRequests(const EvaluationArguments& arguments) {
  const StudyConfig config = loadStudyRunConfig(arguments.config);
  const bool is_master = isMaster();
  const EvaluationPlan plan = planOf(arguments, config);
  const WantedRequests wanted = readWanted(arguments, config);
  const OutputLocks locks = lockFolders({arguments.out, arguments.report});
  SceneSource scenes(arguments.logs, wanted.scenes, config,
                     static_cast<std::size_t>(arguments.jobs) + 1,
                     is_master ? OnWarnings(printWarnings) : OnWarnings(), showReading());
  const RequestEvaluator evaluator(scenes, config, loadPredictionModels(config),
                                   loadMethods(config), plan);
  SearchTimes times;
  const auto rows_of = [&](std::size_t index) {
    EvaluatedRequest evaluated = evaluator.evaluate(wanted.lines[index], wanted.requests[index]);
    times.add(evaluated.times);
    return std::move(evaluated.rows);
  };
  const std::vector<ResultRow> rows = runEvaluation(
      {arguments.out, runOptions(arguments, config, plan, wanted), Protocol::kStrict,
       RowsOf::kRequests, "requests", wanted.lines, rowsPerRequest(plan), arguments.jobs, rows_of});
  if (!is_master) return kExitOk;
  report(arguments, plan, rows, wanted);
  writeScorecard(arguments, plan, config, rows, wanted, scenes);
  times.print();
  if (!arguments.report.empty()) {
    writeReport({{arguments.out + "/results.csv"}, {}}, arguments.report, config,
                evaluationFormats());
  }
  return kExitOk;
}

}  // namespace forge
