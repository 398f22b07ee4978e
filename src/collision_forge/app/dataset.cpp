#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <set>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/evaluation.h"
#include "collision_forge/app/options.h"
#include "collision_forge/batch/dispatch.h"
#include "collision_forge/batch/progress_line.h"
#include "collision_forge/data/collide_export.h"
#include "collision_forge/data/request_file.h"
#include "collision_forge/dataset/balance.h"
#include "collision_forge/dataset/clip_requests.h"
#include "collision_forge/dataset/clip_search.h"
#include "collision_forge/dataset/dataset_statistics.h"
#include "collision_forge/dataset/scene_split.h"
#include "collision_forge/drawing/draw_scenario.h"
#include "collision_forge/files/aside_file.h"
#include "collision_forge/files/resumable_file.h"
#include "collision_forge/settings/config_fingerprint.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::string dataroot;
  std::string version;
  std::vector<std::string> scenes;
  std::string out;
  std::string config;
  std::uint64_t seed = 0;
  bool resume = false;
  int jobs = defaultJobs();

  /// Every clip that was tried, with what came of it.
  std::string attempts() const { return (fs::path(out) / "attempts.jsonl").string(); }
};

std::vector<std::string> wantedScenes(const Arguments& arguments) {
  const std::vector<std::string> names = readSceneNames(arguments.dataroot, arguments.version);
  const std::set<std::string> known(names.begin(), names.end());
  const std::set<std::string> wanted(arguments.scenes.begin(), arguments.scenes.end());
  for (const std::string& name : wanted) {
    if (known.count(name) == 0) {
      throw std::runtime_error("--scene " + name + ": " + arguments.version +
                               " has no scene of that name");
    }
  }
  if (wanted.empty()) return names;
  std::vector<std::string> chosen;
  for (const std::string& name : names) {
    if (wanted.count(name) > 0) chosen.push_back(name);
  }
  return chosen;
}

std::vector<SceneRequest> listRequests(const Arguments& arguments,
                                       const std::vector<std::string>& scenes,
                                       const Config& config) {
  const NuScenesRoot root(arguments.dataroot, arguments.version, {scenes, {}});
  std::vector<SceneRequest> requests;
  for (const std::string& name : root.sceneNames()) {
    const Scene scene = toScene(root.readScene(name), config.ego_vehicle, nullptr);
    for (SceneRequest& request :
         listClipRequests(scene, config.dataset, config.attack.prediction, arguments.seed)) {
      requests.push_back(std::move(request));
    }
  }
  if (requests.empty()) {
    throw std::runtime_error(arguments.dataroot + ": no scene is long enough for a clip of " +
                             std::to_string(config.dataset.min_length) +
                             " s (dataset.min_length) with an ego that moves");
  }
  return requests;
}

ResumableFile::Options runOptions(const Arguments& arguments, const Config& config,
                                  const std::vector<SceneRequest>& requests) {
  ResumableFile::Options options = fingerprintsOf(config, arguments.config);
  options["dataroot"] = fs::canonical(arguments.dataroot).string();
  options["version"] = arguments.version;
  options["seed"] = std::to_string(arguments.seed);
  options["wanted_clips"] = fingerprintOf(requests);
  return options;
}

/// Makes the folder; one that holds a data set, or a part of one, is gone on with if asked.
void openFolder(const Arguments& arguments) {
  const bool begun = fs::exists(arguments.attempts()) || fs::exists(arguments.attempts() + ".part");
  if (begun && !arguments.resume) {
    throw std::runtime_error(arguments.out +
                             ": holds a data set; go on with --resume, or remove it");
  }
  if (!begun && fs::exists(arguments.out) && !fs::is_empty(arguments.out)) {
    throw std::runtime_error(arguments.out + ": holds other files; write elsewhere");
  }
  fs::create_directories(arguments.out);
}

/// What a line says, but for the trajectory.
struct Attempt {
  SceneRequest asked;
  bool valid = false;
  double relative_heading = 0.0;
  double off_road_share = 0.0;

  int length() const {
    return kCollideNowFrame +
           static_cast<int>(std::lround(asked.request.tta / kCollideFrameInterval));
  }
};

/// attempts.jsonl, on the master alone.
class AttemptFile {
 public:
  AttemptFile(const Arguments& arguments, const Config& config,
              const std::vector<SceneRequest>& requests)
      : file_(arguments.attempts(), runOptions(arguments, config, requests)), requests_(requests) {
    if (file_.isComplete()) {
      readComplete(arguments.attempts());
    } else {
      file_.resume(
          [this](const std::string& where, const std::string& line) { keep(where, line); });
    }
    first_ = attempts_.size();
    if (first_ > 0) {
      std::cerr << first_ << " of " << requests.size() << " clips were tried before\n";
    }
  }

  std::size_t first() const { return first_; }
  const std::vector<Attempt>& attempts() const { return attempts_; }

  void take(const std::string& line) {
    file_.append(line);
    keep("the new line", line);
    progress_.show(
        static_cast<double>(attempts_.size() - first_) /
            static_cast<double>(requests_.size() - first_),
        std::to_string(valid_) + " of " + std::to_string(attempts_.size()) + " clips are valid");
  }

  void complete() {
    if (!file_.isComplete()) file_.complete();
  }

 private:
  void readComplete(const std::string& path) {
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
      keep(path + ": line " + std::to_string(attempts_.size() + 1), line);
    }
  }

  void keep(const std::string& where, const std::string& line) {
    const Scenario scenario = readScenarioLine(where, line);
    const std::size_t index = attempts_.size();
    if (index >= requests_.size() || requestLine(scenario.asked) != requestLine(requests_[index])) {
      throw std::runtime_error(where + ": answers " + requestLine(scenario.asked) +
                               ", which is not what was tried there");
    }
    const bool valid = scenario.answer.status.code == StatusCode::kOk;
    const CollisionReport& report = scenario.answer.report;
    attempts_.push_back({scenario.asked, valid, report.relative_heading, report.off_road_share});
    valid_ += valid ? 1 : 0;
  }

  ResumableFile file_;
  const std::vector<SceneRequest>& requests_;
  std::vector<Attempt> attempts_;
  std::size_t first_ = 0;
  std::size_t valid_ = 0;
  ProgressLine progress_{"clips"};
};

/// Places of the attempts that make up the data set, rising.
std::vector<std::size_t> chooseClips(const std::vector<Attempt>& attempts,
                                     const BalanceOptions& options, std::uint64_t seed) {
  std::vector<std::size_t> valid;
  std::vector<ClipKind> kinds;
  for (std::size_t i = 0; i < attempts.size(); ++i) {
    if (!attempts[i].valid) continue;
    valid.push_back(i);
    kinds.push_back({attempts[i].asked.request.type, attempts[i].length()});
  }
  std::vector<std::size_t> chosen;
  for (const std::size_t place : chooseBalanced(kinds, options, seed)) {
    chosen.push_back(valid[place]);
  }
  return chosen;
}

/// Says which types have no clip at all: the others are balanced without them.
void warnOfMissingTypes(const std::vector<Attempt>& attempts) {
  for (const CollisionType type : kCollisionTypes) {
    const bool found = std::any_of(attempts.begin(), attempts.end(), [=](const Attempt& attempt) {
      return attempt.valid && attempt.asked.request.type == type;
    });
    if (!found) std::cerr << "warning: no clip of " << toString(type) << " is valid\n";
  }
}

/// A clip as a picture.
ScenarioView viewOf(const Scenario& scenario, const Scene& scene) {
  const SceneRequest& asked = scenario.asked;
  return {asked.scene,
          asked.request.tta,
          asked.request.mode,
          snapshotAt(scene, asked.now, kCollideNowFrame + 1),
          recordedFuture(scene, asked.now),
          scenario.answer.pattern,
          scenario.answer.trajectory,
          scenario.answer.report};
}

/// Writes all that is made of the chosen attempts.
class DatasetWriter {
 public:
  DatasetWriter(const Arguments& arguments, const Config& config, SceneSource& scenes)
      : arguments_(arguments), config_(config), scenes_(scenes) {}

  void write(const std::vector<Attempt>& attempts, const std::vector<std::size_t>& chosen) {
    deal(attempts, chosen);
    writeClips(chosen);
    drawSheets();
    writeStatistics(attempts);
  }

 private:
  /// A split's part of the clip store, written aside.
  struct Store {
    std::unique_ptr<AsideFile> file;
    std::unique_ptr<CollideExporter> exporter;
  };

  void deal(const std::vector<Attempt>& attempts, const std::vector<std::size_t>& chosen) {
    std::vector<std::string> names;
    for (const std::size_t index : chosen) names.push_back(attempts[index].asked.scene);
    splits_ = splitByScene(names, config_.dataset.split);
    std::map<CollisionType, std::vector<std::size_t>> of_type;
    for (const std::size_t index : chosen) {
      of_type[attempts[index].asked.request.type].push_back(index);
    }
    const int pictures = config_.dataset.sheet_columns * config_.dataset.sheet_rows;
    for (const auto& [type, indices] : of_type) {
      const auto count = std::min(static_cast<std::size_t>(pictures), indices.size());
      for (std::size_t i = 0; i < count; ++i) shown_.insert(indices[i * indices.size() / count]);
    }
  }

  void writeClips(const std::vector<std::size_t>& chosen) {
    fs::create_directories(fs::path(arguments_.out) / "scenarios");
    std::ifstream file(arguments_.attempts());
    std::string line;
    std::size_t next = 0;
    ProgressLine progress("writing");
    for (std::size_t done = 0; done < chosen.size(); ++done) {
      for (; next <= chosen[done]; ++next) std::getline(file, line);
      writeClip(line, chosen[done]);
      progress.show(static_cast<double>(done + 1) / static_cast<double>(chosen.size()));
    }
    for (auto& [split, store] : stores_) {
      store.file->commit();
    }
  }

  void writeClip(const std::string& line, std::size_t index) {
    const std::string where = arguments_.attempts() + ": line " + std::to_string(index + 1);
    Scenario scenario = readScenarioLine(where, line);
    const auto indexed = scenes_.at(scenario.asked.scene);
    const std::string& split = splits_.at(scenario.asked.scene);
    Store& store = storeOf(split);
    store.file->stream() << line << "\n";
    store.exporter->add(scenario, indexed->scene, static_cast<int>(index));
    const CollisionReport& report = scenario.answer.report;
    clips_.push_back({split, scenario.asked.scene, indexed->scene.map->location,
                      scenario.asked.request.type, Attempt{scenario.asked}.length(),
                      report.relative_heading, report.off_road_share});
    if (shown_.count(index) > 0) {
      views_[scenario.asked.request.type].push_back(viewOf(scenario, indexed->scene));
    }
  }

  Store& storeOf(const std::string& split) {
    Store& store = stores_[split];
    if (!store.exporter) {
      const fs::path scenarios = fs::path(arguments_.out) / "scenarios";
      store.file = std::make_unique<AsideFile>((scenarios / (split + ".jsonl")).string());
      store.exporter = std::make_unique<CollideExporter>(arguments_.out, split);
    }
    return store;
  }

  void drawSheets() const {
    const fs::path folder = fs::path(arguments_.out) / "sheets";
    fs::create_directories(folder);
    for (const auto& [type, views] : views_) {
      drawScenarioSheet((folder / (std::string(toString(type)) + ".png")).string(), views,
                        config_.dataset.sheet_columns, config_.drawing);
    }
  }

  void writeStatistics(const std::vector<Attempt>& attempts) const {
    std::map<CollisionType, Attempts> tried;
    for (const Attempt& attempt : attempts) {
      Attempts& sum = tried[attempt.asked.request.type];
      ++sum.tried;
      sum.valid += attempt.valid ? 1 : 0;
    }
    const std::string text = datasetMarkdown(clips_, tried);
    writeText((fs::path(arguments_.out) / "statistics.csv").string(), datasetCsv(clips_));
    writeText((fs::path(arguments_.out) / "statistics.md").string(), text);
    std::cout << text;
  }

  const Arguments& arguments_;
  const Config& config_;
  SceneSource& scenes_;
  std::map<std::string, std::string> splits_;
  std::set<std::size_t> shown_;
  std::map<std::string, Store> stores_;
  std::vector<DatasetClip> clips_;
  std::map<CollisionType, std::vector<ScenarioView>> views_;
};

int buildDataset(const Arguments& arguments) {
  const bool is_master = isMaster();
  const Config config = loadConfig(arguments.config);
  const std::vector<std::string> scene_names = wantedScenes(arguments);
  const std::vector<SceneRequest> requests = listRequests(arguments, scene_names, config);
  std::unique_ptr<AttemptFile> file;
  if (is_master) {
    openFolder(arguments);
    file = std::make_unique<AttemptFile>(arguments, config, requests);
  }
  SceneSource scenes(arguments.dataroot, arguments.version, scene_names, config,
                     static_cast<std::size_t>(arguments.jobs) + 1,
                     is_master ? OnWarnings(printWarnings) : OnWarnings());
  const auto work = [&](std::size_t index) {
    const SceneRequest& asked = requests[index];
    return scenarioLine({asked, config.ego_vehicle,
                         findClip(asked, *scenes.at(asked.scene), config, config.dataset)});
  };
  dispatch(requests.size(), work, [&](std::size_t, const std::string& line) { file->take(line); },
           {arguments.jobs, is_master ? file->first() : 0});
  if (!is_master) return kExitOk;
  file->complete();
  warnOfMissingTypes(file->attempts());
  const std::vector<std::size_t> chosen =
      chooseClips(file->attempts(), config.dataset.balance, arguments.seed);
  if (chosen.empty()) throw std::runtime_error(arguments.out + ": none of the clips is valid");
  DatasetWriter(arguments, config, scenes).write(file->attempts(), chosen);
  return kExitOk;
}

}  // namespace

void addDataset(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app =
      line.add(kTraining, "dataset", "Makes a data set of collisions of logs, in COLLIDE's layout.",
               [arguments] { return buildDataset(*arguments); });
  addLogs(app, arguments->dataroot, arguments->version);
  addScenes(app, arguments->scenes);
  addOut(app, arguments->out, "folder to write; see docs/dataset.md");
  addSeed(app, arguments->seed, "of lengths, headings, searches and the balance");
  addJobs(app, arguments->jobs, "clips at a time, in every rank of mpirun");
  app.add_flag("--resume", arguments->resume, "go on with what a run before left in the folder");
  addConfig(app, arguments->config);
}

}  // namespace forge
