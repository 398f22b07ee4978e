#include <boost/timer/progress_display.hpp>
#include <iostream>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/data/city_maps.h"
#include "collision_forge/data/nuscenes_tables.h"
#include "collision_forge/data/speed_profiles_file.h"
#include "collision_forge/forecast/speed_profile_collection.h"
#include "collision_forge/settings/config.h"

namespace forge {
namespace {

struct Arguments {
  std::string dataroot;
  std::string version;
  std::string out;
  std::string config;
};

int collect(const Arguments& arguments) {
  const Config config = loadConfig(arguments.config);
  const NuScenesRoot root(arguments.dataroot, arguments.version);
  CityMaps lanes(arguments.dataroot, config);
  std::vector<SpeedProfileRow> rows;
  boost::timer::progress_display progress(root.sceneNames().size(), std::cerr);
  for (const std::string& name : root.sceneNames()) {
    const NuScenesRecording recording = root.readScene(name);
    const auto index = lanes.at(recording.location);
    const Scene scene = toScene(recording, config.ego_vehicle, nullptr);
    const auto collected = collectSpeedProfiles(scene, *index, config.attack.ego_futures.paths);
    rows.insert(rows.end(), collected.begin(), collected.end());
    ++progress;
  }
  writeSpeedProfiles(rows, arguments.out);
  std::cout << rows.size() << " rows of " << root.sceneNames().size() << " scenes\n";
  return kExitOk;
}

}  // namespace

void addSpeedsCollect(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app =
      line.add(kTraining, "speeds collect", "Collects how the egos of recorded scenes drove.",
               [arguments] { return collect(*arguments); });
  addLogs(app, arguments->dataroot, arguments->version);
  addOut(app, arguments->out, "CSV to write, a row a frame");
  addConfig(app, arguments->config);
}

}  // namespace forge
