#include <boost/timer/progress_display.hpp>
#include <iostream>

#include "collision_forge/app/lane_indices.h"
#include "collision_forge/app/tool_support.h"
#include "collision_forge/data/nuscenes_tables.h"
#include "collision_forge/data/speed_profiles_file.h"
#include "collision_forge/forecast/speed_profile_collection.h"
#include "collision_forge/settings/config.h"

namespace {

using namespace forge;

struct Arguments {
  std::string dataroot;
  std::string version;
  std::string out;
  std::string config;
};

int collect(const Arguments& arguments) {
  const Config config = loadConfig(arguments.config);
  const NuScenesRoot root(arguments.dataroot, arguments.version);
  LaneIndices lanes(arguments.dataroot, config);
  std::vector<SpeedProfileRow> rows;
  boost::timer::progress_display progress(root.sceneNames().size(), std::cerr);
  for (const std::string& name : root.sceneNames()) {
    const NuScenesRecording recording = root.readScene(name);
    const LaneIndex& index = lanes.at(recording.location);
    const Scene scene = toScene(recording, config.ego_vehicle, nullptr);
    const auto collected = collectSpeedProfiles(scene, index, config.attack.ego_futures.paths);
    rows.insert(rows.end(), collected.begin(), collected.end());
    ++progress;
  }
  writeSpeedProfiles(rows, arguments.out);
  std::cout << rows.size() << " rows of " << root.sceneNames().size() << " scenes\n";
  return kExitOk;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Collects how the ego of recorded scenes drove, to predict other egos from.",
               "collect_speed_profiles");
  app.add_option("--dataroot", arguments.dataroot, "nuScenes root")->required();
  app.add_option("--version", arguments.version, "folder of the tables, as v1.0-trainval")
      ->required();
  app.add_option("--out", arguments.out, "CSV to write, a row a frame")->required();
  addConfigOption(app, arguments.config);
  return runTool(app, argc, argv, [&] { return collect(arguments); });
}
