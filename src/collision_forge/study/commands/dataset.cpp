#include <algorithm>
#include <filesystem>
#include <iostream>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/app/report.h"
#include "collision_forge/base/scene/number_words.h"
#include "collision_forge/io/batch/dispatch.h"
#include "collision_forge/io/batch/output.h"
#include "collision_forge/io/batch/progress_line.h"
#include "collision_forge/io/batch/run.h"
#include "collision_forge/io/scenarios/request_file.h"
#include "collision_forge/study/commands/study_commands.h"
#include "collision_forge/study/commands/study_run_config.h"
#include "collision_forge/study/dataset/attempts.h"
#include "collision_forge/study/dataset/clip_requests.h"
#include "collision_forge/study/dataset/clip_search.h"
#include "collision_forge/study/dataset/dataset_writer.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  LogSource logs;
  std::vector<std::string> scenes;
  std::string out;
  std::string report;
  ConfigFolder config;
  std::uint64_t seed = 0;
  int jobs = defaultJobs();

  /// Returns the path of the file with every clip that was tried and its result.
  std::string attempts() const { return (fs::path(out) / "attempts.jsonl").string(); }
};

/// Sets `unreadable` to the problems of SceneSource::forEach().
std::vector<SceneRequest> listRequests(const Arguments& arguments,
                                       const std::vector<std::string>& scenes,
                                       const StudyConfig& config,
                                       std::vector<std::string>& unreadable) {
  SceneSource source(arguments.logs, scenes, config, 1);
  std::vector<SceneRequest> requests;
  const auto add = [&](const IndexedScene& indexed) {
    for (SceneRequest& request : listClipRequests(indexed.scene, config.dataset,
                                                  config.attack.prediction, arguments.seed)) {
      request.request.crash = config.crash;
      requests.push_back(std::move(request));
    }
  };
  unreadable = source.forEach(add);
  if (requests.empty()) {
    throw std::runtime_error(arguments.logs.path +
                             ": no scene has frames at 2 Hz or more over a clip of " +
                             numberText(config.dataset.min_length) +
                             " s (dataset.min_length) and with an ego of at least " +
                             numberText(config.dataset.min_ego_speed) +
                             " m/s (dataset.min_ego_speed)" + unreadableText(unreadable));
  }
  return requests;
}

ResumableFile::Options runOptions(const Arguments& arguments, const StudyConfig& config,
                                  const std::vector<SceneRequest>& requests) {
  ResumableFile::Options options = studyInputsOf(config, arguments.logs);
  options["seed"] = std::to_string(arguments.seed);
  options["wanted_clips"] = fingerprintOf(requests);
  return options;
}

/// Returns the first path component of the HTML report relative to the data set's folder, or an
/// empty path without a report.
fs::path pageIn(const Arguments& arguments) {
  if (arguments.report.empty()) return {};
  const fs::path page = fs::weakly_canonical(arguments.report)
                            .lexically_relative(fs::weakly_canonical(arguments.out));
  return *page.begin();
}

/// Throws std::runtime_error if the output folder holds files that do not belong to an interrupted
/// run.
void checkFolder(const Arguments& arguments) {
  const bool begun = fs::exists(arguments.attempts()) || fs::exists(arguments.attempts() + ".part");
  if (begun) return;
  for (const auto& entry : fs::directory_iterator(arguments.out)) {
    const fs::path name = entry.path().filename();
    if (name == OutputLock::kFileName || name == pageIn(arguments)) continue;
    throw std::runtime_error(arguments.out + ": contains other files (" + name.string() +
                             "); choose another --out");
  }
}

/// Warns about types without any valid clip; the other types are balanced without them.
void warnOfMissingTypes(const std::vector<Attempt>& attempts) {
  for (const CollisionType type : kCollisionTypes) {
    const bool found = std::any_of(attempts.begin(), attempts.end(), [=](const Attempt& attempt) {
      return attempt.valid && attempt.asked.request.type == type;
    });
    if (!found) printLine(std::string("warning: no valid clip of type ") + toString(type));
  }
}

int buildDataset(const Arguments& arguments) {
  const StudyConfig config = loadStudyConfig(arguments.config);
  const std::vector<std::string> names = wantedScenes(arguments.logs, arguments.scenes);
  const OutputLocks locks = lockFolders({arguments.out, arguments.report});
  checkFolder(arguments);
  std::vector<std::string> unreadable;
  const std::vector<SceneRequest> requests = listRequests(arguments, names, config, unreadable);
  SceneSource scenes(arguments.logs, names, config, static_cast<std::size_t>(arguments.jobs) + 1,
                     printWarnings, showReading());
  std::vector<Attempt> attempts;
  Run run;
  run.path = arguments.attempts();
  run.options = runOptions(arguments, config, requests);
  run.items = "clips";
  run.count = requests.size();
  run.jobs = arguments.jobs;
  run.work = [&](std::size_t index) {
    const SceneRequest& asked = requests[index];
    const auto scene = scenes.at(asked.scene);
    return scenarioLine({asked, egoVehicleOf(scene->scene, config.ego_vehicle.center_offset),
                         findClip(asked, *scene, config, config.dataset)});
  };
  run.take = [&](std::size_t index, const std::string& where, const std::string& line) {
    attempts.push_back(readAttempt(where, line, requests[index], config.input_limits));
  };
  carryOut(run);
  warnOfMissingTypes(attempts);
  const auto chosen = chooseClips(attempts, config.dataset.balance, arguments.seed);
  if (chosen.empty()) {
    throw std::runtime_error(arguments.out + ": no clip is valid; see attempts.jsonl for reasons");
  }
  std::cout << writeDataset(arguments.out, arguments.attempts(), attempts, chosen, config.dataset,
                            config.input_limits, scenes);
  if (!arguments.report.empty()) {
    writeReport({{arguments.attempts()}, arguments.logs}, arguments.report, config);
  }
  return exitAfterUnreadable(unreadable);
}

}  // namespace

void addDataset(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app = line.add(kTraining, "study dataset",
                           "Makes a collision data set from logs, in COLLIDE's layout.",
                           [arguments] { return buildDataset(*arguments); });
  addSource(app, arguments->logs)->required();
  addScenes(app, arguments->scenes);
  addOut(app, arguments->out, "output folder; see docs/dataset.md");
  addSeed(app, arguments->seed, "random seed of lengths, headings, attack searches and balancing");
  addJobs(app, arguments->jobs, "clips searched in parallel");
  addReportOption(app, arguments->report);
  addConfig(app, arguments->config);
}

}  // namespace forge
