#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <set>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/app/report.h"
#include "collision_forge/app/scenario_run.h"
#include "collision_forge/base/scene/number_words.h"
#include "collision_forge/io/batch/dispatch.h"
#include "collision_forge/io/batch/output.h"
#include "collision_forge/io/batch/progress_line.h"
#include "collision_forge/io/collide/collide_export.h"
#include "collision_forge/io/json/input_line.h"
#include "collision_forge/io/scenarios/request_file.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

enum class Format { kJsonl, kCsvCollide };

struct Arguments {
  LogSource logs;
  std::string requests;
  std::string out;
  ConfigFolder config;
  std::string method;
  std::string report;
  RequestControls controls;
  Mode mode = Mode::kReplay;
  Format format = Format::kJsonl;
  int jobs = defaultJobs();

  /// Returns the path of the scenario file.
  std::string scenarios() const {
    return format == Format::kJsonl ? out : (fs::path(out) / "scenarios.jsonl").string();
  }
};

struct RequestList {
  std::vector<SceneRequest> requests;  ///< with the mode and the controls of the command line
  std::vector<std::string> scenes;     ///< names, in order of first use
};

RequestList readList(const Arguments& arguments, const Config& config) {
  const auto names = readSceneNames(arguments.logs);
  RequestList list;
  list.requests = readRequests(arguments.requests, {names.begin(), names.end()},
                               config.input_limits, config.crash);
  std::set<std::string> seen;
  for (SceneRequest& request : list.requests) {
    request.request.mode = arguments.mode;
    arguments.controls.applyTo(request.request);
    if (seen.insert(request.scene).second) list.scenes.push_back(request.scene);
  }
  return list;
}

/// Rejects an output folder with clips but without a scenario file. Clips are written after all
/// scenarios, so existing clips without scenarios belong to another run.
void checkFolder(const Arguments& arguments) {
  const std::string clips = CollideExporter::folderIn(arguments.out);
  if (!fs::exists(arguments.scenarios()) && fs::exists(clips) && !fs::is_empty(clips)) {
    throw std::runtime_error(clips + ": contains clips of another run (" + arguments.scenarios() +
                             " is missing); delete them or choose another --out");
  }
}

/// Locks the scenario file, or its folder for csv-collide, and the report folder.
OutputLocks lockOutputs(const Arguments& arguments) {
  OutputLocks locks =
      lockFolders({arguments.format == Format::kCsvCollide ? arguments.out : "", arguments.report});
  if (arguments.format == Format::kJsonl) {
    for (OutputLock& lock : lockFile(arguments.out)) locks.push_back(std::move(lock));
  }
  return locks;
}

/// Writes the missing COLLIDE clips of all solved requests.
void exportClips(const Arguments& arguments, std::size_t count, SceneSource& scenes,
                 const InputLimits& limits) {
  const std::string path = arguments.scenarios();
  CollideExporter exporter(arguments.out);
  ProgressLine progress("clips");
  std::ifstream file(path);
  int index = 0;
  const auto where = [&] { return path + ": line " + std::to_string(index + 1); };
  for (std::string line; readInputLine(file, line, where(), limits); ++index) {
    const Scenario scenario = readScenarioLine(where(), line, limits);
    if (scenario.answer.status.code == StatusCode::kOk) {
      exporter.add(scenario, scenes.at(scenario.asked.scene)->scene, index);
    }
    progress.show(static_cast<std::size_t>(index) + 1, count);
  }
  if (!exporter.complaint().empty()) printLine(exporter.complaint());
  std::cout << counted(exporter.clips(), "clip") << " in "
            << CollideExporter::folderIn(arguments.out) << "\n";
}

int generate(const Arguments& arguments) {
  const Config config = loadConfig(arguments.config);
  const RequestList list = readList(arguments, config);
  const OutputLocks locks = lockOutputs(arguments);
  if (arguments.format == Format::kCsvCollide) checkFolder(arguments);
  SceneSource scenes(arguments.logs, list.scenes, config,
                     static_cast<std::size_t>(arguments.jobs) + 1, printWarnings, showReading());
  std::size_t attacks = 0;
  writeScenarios({arguments.scenarios(), arguments.requests, list.requests, arguments.method,
                  arguments.mode, arguments.jobs},
                 arguments.logs, scenes, config, [&](const Scenario& scenario) {
                   if (scenario.answer.status.code == StatusCode::kOk) ++attacks;
                 });
  std::cout << counted(list.requests.size(), "request") << " in " << arguments.scenarios() << ": "
            << attacks << " solved, " << list.requests.size() - attacks << " rejected\n";
  if (arguments.format == Format::kCsvCollide) {
    exportClips(arguments, list.requests.size(), scenes, config.input_limits);
  }
  if (!arguments.report.empty()) {
    writeReport({{arguments.scenarios()}, arguments.logs}, arguments.report, config);
  }
  return kExitOk;
}

}  // namespace

void addGenerate(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app = line.add(kMakingCollisions, "generate",
                           "Makes collision scenarios from a list of requests; resumes interrupted "
                           "runs.",
                           [arguments] { return generate(*arguments); });
  addSource(app, arguments->logs)->required();
  app.add_option("--requests", arguments->requests, "request list of forge requests")->required();
  addOut(app, arguments->out,
         "output scenario file, one JSON line per request; for csv-collide an output folder");
  addChoice<Format>(app, "--format", arguments->format,
                    {{"jsonl", Format::kJsonl}, {"csv-collide", Format::kCsvCollide}},
                    "output format; csv-collide: scenarios.jsonl and, for each attack, a clip in "
                    "COLLIDE's layout in trajectory/val");
  addMethod(app, arguments->method, arguments->config);
  addMode(app, arguments->mode, true);
  addAttacker(app, arguments->controls);
  addControls(app, arguments->controls);
  addAlternatives(app, arguments->controls);
  addJobs(app, arguments->jobs, "requests processed in parallel");
  addReportOption(app, arguments->report);
  addConfig(app, arguments->config);
}

}  // namespace forge
