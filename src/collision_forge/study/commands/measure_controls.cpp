#include <iostream>
#include <set>
#include <stdexcept>
#include <utility>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/io/batch/dispatch.h"
#include "collision_forge/io/batch/output.h"
#include "collision_forge/io/batch/run.h"
#include "collision_forge/io/scenarios/request_file.h"
#include "collision_forge/io/weights/pattern_network_file.h"
#include "collision_forge/study/commands/study_commands.h"
#include "collision_forge/study/commands/study_run_config.h"
#include "collision_forge/study/evaluation/control_report.h"

namespace forge {
namespace {

struct Arguments {
  LogSource logs;
  std::string requests;
  std::string out;
  ConfigFolder config;
  std::string method;
  int jobs = defaultJobs();
};

struct QuestionsOfList {
  std::string fingerprint;  ///< of the request list
  std::vector<ControlQuestion> questions;
  std::vector<std::string> scenes;  ///< names, in order of first use
};

QuestionsOfList readQuestions(const Arguments& arguments, const StudyConfig& config) {
  const auto names = readSceneNames(arguments.logs);
  const std::vector<SceneRequest> requests = readRequests(
      arguments.requests, {names.begin(), names.end()}, config.input_limits, config.crash);
  QuestionsOfList list;
  list.fingerprint = fingerprintOf(requests);
  std::set<std::string> seen;
  for (std::size_t i = 0; i < requests.size(); ++i) {
    if (seen.insert(requests[i].scene).second) list.scenes.push_back(requests[i].scene);
    for (ControlQuestion& question :
         controlQuestions(std::to_string(i + 1), requests[i], config.evaluation.controls)) {
      list.questions.push_back(std::move(question));
    }
  }
  return list;
}

std::vector<AnsweredQuestion> answerAll(const Arguments& arguments, const StudyConfig& config,
                                        const QuestionsOfList& list) {
  SceneSource scenes(arguments.logs, list.scenes, config,
                     static_cast<std::size_t>(arguments.jobs) + 1,
                     isMaster() ? OnWarnings(printWarnings) : OnWarnings(), showReading());
  const ControlEvaluator evaluator(scenes, loadMethod(arguments.method, config, config.attack),
                                   config, config.ego_vehicle);
  std::vector<AnsweredQuestion> answered;
  Run run;
  run.path = arguments.out + "/results.csv";
  run.options = studyInputsOf(config, arguments.logs);
  run.options["requests"] = list.fingerprint;
  if (!arguments.method.empty()) run.options["method"] = arguments.method;
  run.layout.header = controlCsvHeader();
  run.items = "questions";
  run.count = list.questions.size();
  run.jobs = arguments.jobs;
  run.work = [&](std::size_t index) {
    const ControlQuestion& question = list.questions[index];
    return toCsv(question, evaluator.answer(question));
  };
  run.take = [&](std::size_t index, const std::string& where, const std::string& line) {
    const auto answer = controlAnswerFromCsv(line, list.questions[index]);
    if (!answer) {
      throw std::runtime_error(where + ": \"" + line +
                               "\" is not a row of this run; choose another --out");
    }
    answered.emplace_back(list.questions[index], *answer);
  };
  carryOut(run);
  return answered;
}

int measure(const Arguments& arguments) {
  const StudyConfig config = loadStudyRunConfig(arguments.config);
  const QuestionsOfList list = readQuestions(arguments, config);
  const OutputLocks locks = lockFolders({arguments.out});
  const std::vector<AnsweredQuestion> answered = answerAll(arguments, config, list);
  if (!isMaster()) return kExitOk;
  const std::vector<ControlRates> rates = controlRates(answered);
  const std::string table = toMarkdown(rates);
  writeText(arguments.out + "/table.md", table);
  writeText(arguments.out + "/table.csv", toCsv(rates));
  std::cout << table;
  return kExitOk;
}

}  // namespace

void addMeasureControls(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app = line.add(
      kMeasuring, "study measure controls",
      "Runs one request per value of each control; reports success and whether the constraint was "
      "met.",
      [arguments] { return measure(*arguments); });
  addSource(app, arguments->logs)->required();
  app.add_option("--requests", arguments->requests, "request list of forge requests")
      ->required()
      ->check(CLI::ExistingFile);
  addOut(app, arguments->out,
         "output folder for results.csv, table.md and table.csv; resumes an interrupted run");
  addMethod(app, arguments->method, arguments->config);
  addJobs(app, arguments->jobs, "requests processed in parallel on each MPI rank");
  addConfig(app, arguments->config);
}

}  // namespace forge
