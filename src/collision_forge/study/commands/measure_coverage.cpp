#include <iostream>
#include <map>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/attack/search/generate_collision.h"
#include "collision_forge/attack/verify/verification.h"
#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/base/files/output_lock.h"
#include "collision_forge/io/batch/progress_line.h"
#include "collision_forge/io/logs/scene_source.h"
#include "collision_forge/io/weights/pattern_network_file.h"
#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/study/commands/study_commands.h"

namespace forge {
namespace {

struct Arguments {
  LogSource logs;
  std::string out;
  ConfigFolder config;
  std::vector<double> nows = {4.0, 8.0, 12.0};
  std::vector<double> ttas = {2.0, 4.0, 6.0};
};

/// Counts the outcomes of requests of one mode and type.
struct Tally {
  std::map<StatusCode, int> codes;
  int confirmed = 0;  ///< attacks that also pass the checks against the recorded future
};
using Tallies = std::map<std::pair<Mode, CollisionType>, Tally>;

void answerAll(const IndexedScene& indexed, double seconds, const Arguments& arguments,
               const Config& config, const MethodMaker& maker, std::ostream& csv,
               Tallies& tallies) {
  const Scene& scene = indexed.scene;
  const PredictionOptions& prediction = config.attack.prediction;
  const double asked = scene.frame_times.front() + seconds;
  if (asked > scene.frame_times.back()) return;
  const double now = lastFrameTime(scene, asked).value();
  const auto moment = std::get<Moment>(momentAt(indexed, now, prediction.history_frames));
  const auto method = maker.makeWithoutScene(scene.name);
  for (const Mode mode : {Mode::kHistory, Mode::kReplay}) {
    for (const CollisionType type : kCollisionTypes) {
      for (const double tta : arguments.ttas) {
        CollisionRequest request;
        request.type = type;
        request.tta = tta;
        request.mode = mode;
        request.crash = config.crash;
        const Realization attack = generateCollision(*method, moment, request, prediction);
        Tally& tally = tallies[{mode, type}];
        ++tally.codes[attack.status.code];
        bool confirmed = false;
        if (attack.status.code == StatusCode::kOk) {
          confirmed =
              verify(attack.trajectory, {moment.snapshot, *moment.recorded, request, *moment.lanes},
                     config.attack.verification)
                  .verified();
          tally.confirmed += confirmed;
        }
        csv << scene.name << ',' << seconds << ',' << toString(mode) << ',' << toString(type) << ','
            << tta << ',' << toString(attack.status.code) << ',' << attack.trajectory.attacker_id
            << ',' << attack.report.confidence << ',' << attack.report.off_road_share << ','
            << confirmed << '\n';
      }
    }
  }
}

void printTable(const Tallies& tallies) {
  std::cout << "| mode | type | requests | solved | solved and confirmed by the recording | other "
               "codes |\n|---|---|---|---|---|---|\n";
  for (const auto& [key, tally] : tallies) {
    int requests = 0;
    int verified = 0;
    std::string others;
    for (const auto& [code, count] : tally.codes) {
      requests += count;
      if (code == StatusCode::kOk) {
        verified = count;
      } else {
        others += (others.empty() ? "" : ", ") + std::string(toString(code)) + " " +
                  std::to_string(count);
      }
    }
    std::cout << "| " << toString(key.first) << " | " << toString(key.second) << " | " << requests
              << " | " << verified << " | " << tally.confirmed << " | " << others << " |\n";
  }
}

int measure(const Arguments& arguments) {
  const Config config = loadConfig(arguments.config);
  const MethodMaker method = loadMethod("", config, config.attack);
  const OutputLock lock = OutputLock::ofFile(arguments.out);
  AsideFile file(arguments.out);
  SceneSource scenes(arguments.logs, {}, config, 1, {}, showReading());
  const std::vector<std::string> names = scenes.names();
  std::ostream& csv = file.stream();
  csv << "scene,now,mode,type,tta,code,attacker,confidence,off_road_share,confirmed\n";
  Tallies tallies;
  ProgressLine progress("scenes");
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto scene = scenes.at(names[i]);
    for (const double now : arguments.nows) {
      answerAll(*scene, now, arguments, config, method, csv, tallies);
    }
    progress.show(i + 1, names.size());
  }
  file.commit();
  printTable(tallies);
  return kExitOk;
}

}  // namespace

void addMeasureCoverage(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app = line.add(kMeasuring, "study measure coverage",
                           "Runs one request per type, TTA and mode in every scene; reports the "
                           "outcomes.",
                           [arguments] { return measure(*arguments); });
  addSource(app, arguments->logs)->required();
  addOut(app, arguments->out, "output CSV file, one row per request");
  app.add_option("--now", arguments->nows,
                 "times of the request t0, s from each scene's first frame")
      ->capture_default_str();
  app.add_option("--tta", arguments->ttas, "times to attack, s: time from t0 to contact")
      ->capture_default_str();
  addConfig(app, arguments->config);
}

}  // namespace forge
