#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/batch/dispatch.h"
#include "collision_forge/batch/output.h"
#include "collision_forge/batch/progress_line.h"
#include "collision_forge/data/city_maps.h"
#include "collision_forge/data/nuscenes_map.h"
#include "collision_forge/data/nuscenes_tables.h"
#include "collision_forge/files/plain_name.h"
#include "collision_forge/ros/bag_writer.h"
#include "collision_forge/settings/config.h"

namespace forge {
namespace {

struct Arguments {
  std::string dataroot;
  std::string version;
  std::vector<std::string> scenes;
  std::string out;
  std::string config;
  int jobs = defaultJobs();
  bool force = false;
};

std::string bagPath(const Arguments& arguments, const std::string& scene) {
  return pathIn(arguments.out, scene + ".bag");
}

/// True for a scene that has its bag: a bag has its name only when it is complete.
bool isConverted(const Arguments& arguments, const std::string& scene) {
  return !arguments.force && std::filesystem::exists(bagPath(arguments, scene));
}

/// The map around everything that was recorded.
LaneMap mapAround(const NuScenesRecording& recording, const LaneMap& map, double radius) {
  std::vector<Vector2> points;
  for (const NuScenesEgoPose& pose : recording.ego_poses) {
    const Vector2 point = pose.translation.head<2>();
    constexpr double kSpacing = 5.0;  // m; closer points add nothing to the crop
    if (points.empty() || (point - points.back()).norm() > kSpacing) points.push_back(point);
  }
  return cropped(map, points, radius);
}

int convert(const Arguments& arguments) {
  const Config config = loadConfig(arguments.config);
  const OutputLocks locks = lockFolders({arguments.out});
  std::cerr << "reading " << arguments.dataroot << "/" << arguments.version << "\n";
  const NuScenesRoot root(arguments.dataroot, arguments.version, {arguments.scenes, showReading()});
  const std::vector<std::string> scenes = root.sceneNames();
  const auto before = static_cast<std::size_t>(
      std::count_if(scenes.begin(), scenes.end(),
                    [&](const std::string& scene) { return isConverted(arguments, scene); }));
  if (isMaster()) {
    std::cerr << scenes.size() - before << " scenes to convert, " << before
              << " converted before\n";
  }
  CityMaps maps(arguments.dataroot, config, isMaster() ? OnWarnings(printWarnings) : OnWarnings());
  const auto convertScene = [&](std::size_t index) -> std::string {
    const std::string& scene = scenes[index];
    if (isConverted(arguments, scene)) return "";
    try {
      const NuScenesRecording recording = root.readScene(scene);
      writeBag(bagPath(arguments, scene), recording,
               mapAround(recording, *maps.at(recording.location)->sharedMap(),
                         config.conversion.map_radius));
      return "";
    } catch (const std::exception& error) {
      return scene + ": " + error.what();
    }
  };
  ProgressLine progress("scenes");
  std::size_t failures = 0;
  const auto take = [&](std::size_t index, const std::string& failure) {
    progress.show(index + 1, scenes.size());
    if (failure.empty()) return;
    ++failures;
    printLine("not converted: " + failure);
  };
  dispatch(scenes.size(), convertScene, take, {arguments.jobs, 0});
  if (!isMaster()) return kExitOk;
  std::cerr << scenes.size() - before - failures << " bags written to " << arguments.out << "\n";
  return failures == 0 ? kExitOk : kExitError;
}

}  // namespace

void addConvert(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app = line.add(kMakingCollisions, "convert",
                           "Converts nuScenes scenes to bags: poses, agents, lane map, markers.",
                           [arguments] { return convert(*arguments); });
  addLogs(app, arguments->dataroot, arguments->version);
  addScenes(app, arguments->scenes);
  addOut(app, arguments->out, "folder for the bags, one a scene");
  addJobs(app, arguments->jobs, "scenes at a time");
  app.add_flag("--force", arguments->force, "convert again what has been converted");
  addConfig(app, arguments->config);
}

}  // namespace forge
