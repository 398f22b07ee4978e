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
#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/io/batch/dispatch.h"
#include "collision_forge/io/batch/output.h"
#include "collision_forge/io/scenarios/request_file.h"
#include "collision_forge/io/weights/pattern_network_file.h"
#include "collision_forge/planner_test/settings/config_fingerprint.h"
#include "collision_forge/study/commands/evaluation.h"
#include "collision_forge/study/commands/study_commands.h"
#include "collision_forge/study/commands/study_run_config.h"
#include "collision_forge/study/evaluation/request_evaluation.h"
#include "collision_forge/study/evaluation/request_report.h"

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
  std::string text = reportTitle(title);
  const std::vector<RateTable> tables = requestTables(rows, plan);
  for (const RateTable& table : tables) text += "\n" + toMarkdown(table);
  writeRates(tables, arguments.out);
  const auto calibration = requestCalibration(rows, plan);
  if (calibration) text += "\n" + toMarkdown(*calibration);
  writeText(arguments.out + "/table.md", text);
  std::cout << text << std::endl;
}

}  // namespace

int evaluateRequests(const EvaluationArguments& arguments) {
  const StudyConfig config = loadStudyConfig(arguments.config);
  const EvaluationPlan plan = planOf(arguments, config);
  const WantedRequests wanted = readWanted(arguments, config);
  const OutputLocks locks = lockFolders({arguments.out});
  SceneSource scenes(arguments.logs, wanted.scenes, config,
                     static_cast<std::size_t>(arguments.jobs) + 1, printWarnings, showReading());
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
  report(arguments, plan, rows, wanted);
  times.print();
  return kExitOk;
}

}  // namespace forge
