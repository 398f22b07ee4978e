#include <atomic>
#include <boost/timer/progress_display.hpp>
#include <filesystem>
#include <iostream>
#include <map>
#include <mutex>
#include <thread>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/batch/dispatch.h"
#include "collision_forge/data/nuscenes_map.h"
#include "collision_forge/data/nuscenes_tables.h"
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

std::filesystem::path bagPath(const Arguments& arguments, const std::string& scene) {
  return std::filesystem::path(arguments.out) / (scene + ".bag");
}

/// Scenes whose bag is not there yet; a bag has its name only when it is complete.
std::vector<std::string> missingScenes(const Arguments& arguments,
                                       const std::vector<std::string>& scenes) {
  std::vector<std::string> missing;
  for (const std::string& scene : scenes) {
    if (arguments.force || !std::filesystem::exists(bagPath(arguments, scene))) {
      missing.push_back(scene);
    }
  }
  return missing;
}

/// The maps of the places driven in, each read once. Thread-safe.
class Maps {
 public:
  Maps(const Arguments& arguments, const Config& config) : arguments_(arguments), config_(config) {}

  std::shared_ptr<const LaneMap> at(const std::string& location) {
    const std::lock_guard<std::mutex> lock(mutex_);
    auto& map = maps_[location];
    if (!map) {
      std::vector<std::string> warnings;
      map = std::make_shared<const LaneMap>(
          readNuScenesMap(arguments_.dataroot, location, drivingSide(config_, location),
                          {config_.conversion.centerline_resolution}, &warnings));
      printWarnings("map " + location, warnings);
    }
    return map;
  }

 private:
  const Arguments& arguments_;
  const Config& config_;
  std::mutex mutex_;
  std::map<std::string, std::shared_ptr<const LaneMap>> maps_;
};

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

/// A progress bar over the bytes of the tables.
NuScenesProgress showReading() {
  std::shared_ptr<boost::timer::progress_display> bar;
  return [bar](std::uint64_t done, std::uint64_t total) mutable {
    if (!bar) bar = std::make_shared<boost::timer::progress_display>(total, std::cerr);
    *bar += done - bar->count();
  };
}

int convert(const Arguments& arguments) {
  const Config config = loadConfig(arguments.config);
  std::filesystem::create_directories(arguments.out);
  std::cerr << "reading " << arguments.dataroot << "/" << arguments.version << "\n";
  const NuScenesRoot root(arguments.dataroot, arguments.version, {arguments.scenes, showReading()});
  const std::vector<std::string> scenes = missingScenes(arguments, root.sceneNames());
  std::cerr << scenes.size() << " scenes to convert, " << root.sceneNames().size() - scenes.size()
            << " converted before\n";
  if (scenes.empty()) return kExitOk;

  Maps maps(arguments, config);
  boost::timer::progress_display progress(scenes.size(), std::cerr);
  std::mutex mutex;
  std::vector<std::string> failures;
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < scenes.size(); i = next++) {
      std::string failure;
      try {
        const NuScenesRecording recording = root.readScene(scenes[i]);
        writeBag(bagPath(arguments, scenes[i]), recording,
                 mapAround(recording, *maps.at(recording.location), config.conversion.map_radius));
      } catch (const std::exception& error) {
        failure = scenes[i] + ": " + error.what();
      }
      const std::lock_guard<std::mutex> lock(mutex);
      ++progress;
      if (!failure.empty()) failures.push_back(failure);
    }
  };
  std::vector<std::thread> workers;
  for (int i = 1; i < arguments.jobs; ++i) workers.emplace_back(work);
  work();
  for (std::thread& worker : workers) worker.join();

  for (const std::string& failure : failures) std::cerr << "not converted: " << failure << "\n";
  std::cerr << scenes.size() - failures.size() << " bags written to " << arguments.out << "\n";
  return failures.empty() ? kExitOk : kExitError;
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
