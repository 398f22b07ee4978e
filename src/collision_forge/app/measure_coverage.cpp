#include <boost/timer/progress_display.hpp>
#include <iostream>
#include <map>

#include "collision_forge/app/tool_support.h"
#include "collision_forge/attack/generator.h"
#include "collision_forge/data/nuscenes_map.h"
#include "collision_forge/data/nuscenes_tables.h"
#include "collision_forge/data/pattern_network_file.h"
#include "collision_forge/files/aside_file.h"
#include "collision_forge/settings/config.h"

namespace {

using namespace forge;

struct Arguments {
  std::string dataroot;
  std::string version;
  std::string out;
  std::string config;
  std::vector<double> nows = {4.0, 8.0, 12.0};
  std::vector<double> ttas = {2.0, 4.0, 6.0};
};

/// Outcomes by mode and type: status code, and for kOk whether the recording bore it out.
struct Tally {
  std::map<StatusCode, int> codes;
  int confirmed = 0;
};
using Tallies = std::map<std::pair<Mode, CollisionType>, Tally>;

void answerAll(const Scene& scene, double seconds, const LaneIndex& lanes,
               const Arguments& arguments, const Config& config, const Foresight& foresight,
               std::ostream& csv, Tallies& tallies) {
  const auto now = lastFrameTime(scene, scene.frame_times.front() + seconds);
  const Snapshot snapshot = snapshotAt(scene, *now, config.attack.prediction.history_frames);
  const Future recorded = recordedFuture(scene, *now);
  const auto predictor = foresight.withoutScene(scene.name).patterns(config.attack);
  for (const Mode mode : {Mode::kHistory, Mode::kReplay}) {
    for (const CollisionType type : kCollisionTypes) {
      for (const double tta : arguments.ttas) {
        CollisionRequest request;
        request.type = type;
        request.tta = tta;
        request.mode = mode;
        const Realization attack =
            generateCollision(request, snapshot, lanes, &recorded, *predictor, config.attack);
        Tally& tally = tallies[{mode, type}];
        ++tally.codes[attack.status.code];
        bool confirmed = false;
        if (attack.status.code == StatusCode::kOk) {
          confirmed = verify(attack.trajectory, {snapshot, recorded, request, lanes}, config.attack)
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
  std::cout << "| mode | type | requests | crash verified | of these borne out by the recording | "
               "other codes |\n|---|---|---|---|---|---|\n";
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
  const Foresight foresight = loadForesight(config);
  const NuScenesRoot root(arguments.dataroot, arguments.version);
  std::map<std::string, std::shared_ptr<const LaneMap>> maps;
  AsideFile file(arguments.out);
  std::ostream& csv = file.stream();
  csv << "scene,now,mode,type,tta,code,attacker,confidence,off_road_share,confirmed\n";
  Tallies tallies;
  boost::timer::progress_display progress(root.sceneNames().size(), std::cerr);
  for (const std::string& name : root.sceneNames()) {
    const NuScenesRecording recording = root.readScene(name);
    auto& map = maps[recording.location];
    if (!map) {
      map = std::make_shared<const LaneMap>(readNuScenesMap(
          arguments.dataroot, recording.location, drivingSide(config, recording.location),
          {config.conversion.centerline_resolution}));
    }
    const Scene scene = toScene(recording, config.ego_vehicle, map);
    const LaneIndex lanes(map);
    for (const double now : arguments.nows) {
      answerAll(scene, now, lanes, arguments, config, foresight, csv, tallies);
    }
    ++progress;
  }
  file.commit();
  printTable(tallies);
  return kExitOk;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Asks for every type and TTA in every scene, in both modes, and tells what came.",
               "measure_coverage");
  app.add_option("--dataroot", arguments.dataroot, "nuScenes root")->required();
  app.add_option("--version", arguments.version, "folder of the tables, as v1.0-mini")->required();
  app.add_option("--out", arguments.out, "CSV to write, a row a request")->required();
  app.add_option("--now", arguments.nows, "seconds from each scene's first frame")
      ->capture_default_str();
  app.add_option("--tta", arguments.ttas, "seconds from now to impact")->capture_default_str();
  addConfigOption(app, arguments.config);
  return runTool(app, argc, argv, [&] { return measure(arguments); });
}
