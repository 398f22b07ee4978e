#include <Eigen/Geometry>
#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>
#include <stdexcept>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/base/files/plain_name.h"
#include "collision_forge/base/scene/number_words.h"
#include "collision_forge/io/batch/dispatch.h"
#include "collision_forge/io/batch/output.h"
#include "collision_forge/io/batch/progress_line.h"
#include "collision_forge/io/export/scenario_net_description.h"
#include "collision_forge/io/export/scenario_net_scene.h"
#include "collision_forge/io/lidar/simulated_sweep.h"
#include "collision_forge/io/logs/nuscenes_map.h"
#include "collision_forge/io/logs/nuscenes_sensors.h"
#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/ros/bags/bag_writer.h"
#include "collision_forge/ros/bags/copied_sensors.h"
#include "collision_forge/ros/bags/foreign_logs.h"
#include "collision_forge/ros/bags/log_sources.h"

namespace forge {
namespace {

/// Where the sensor data of a bag come from.
enum class SensorOrigin {
  kNone,
  kFiles,      ///< the files of a nuScenes root
  kSimulated,  ///< a lidar is simulated
};

struct Arguments {
  LogSource logs;
  std::vector<std::string> scenes;
  std::string out;
  ConfigFolder config;
  std::string topics;  ///< topic mapping of third-party bags; empty: `logs` has none
  bool without_lanes = false;
  std::string map;  ///< map file of third-party bags; empty: /lane_map of each bag
  int jobs = defaultJobs();
  bool force = false;
  bool to_scenario_net = false;
  RowTimes rows = RowTimes::kEveryStep;  ///< time stamps of ScenarioNet rows
  SensorOrigin sensors = SensorOrigin::kNone;
};

/// The sensor files of the converted scenes, by scene.
using SensorScenes = std::map<std::string, NuScenesSensorScene>;

/// Returns the path of the output file of a scene.
std::string resultPath(const Arguments& arguments, const std::string& scene) {
  return pathIn(arguments.out, arguments.to_scenario_net ? scenarioNetFile(scene) : scene + ".bag");
}

/// Returns true if the output file exists; files get their final name only when complete.
bool isConverted(const Arguments& arguments, const std::string& scene) {
  return !arguments.force && std::filesystem::exists(resultPath(arguments, scene));
}

/// Returns words for a map without a lane within `radius` (m) of the ego's path.
std::string farWords(const NuScenesEgoPose& start, const LaneMap& map, double radius) {
  Eigen::AlignedBox2d box;
  for (const Lane& lane : map.lanes) {
    for (const Pose2& pose : lane.centerline) box.extend(pose.position());
  }
  std::ostringstream words;
  words << std::fixed << std::setprecision(0) << "no lane of the map " << map.location
        << " is within " << radius << " m of the ego's path, which begins at ("
        << start.translation.x() << ", " << start.translation.y() << "); the lanes are within ("
        << box.min().x() << ", " << box.min().y() << ") and (" << box.max().x() << ", "
        << box.max().y() << "): the log and the map have different coordinates";
  return words.str();
}

/// Returns the part of the map within `radius` (m) of the recorded ego path. Throws
/// std::runtime_error if the map has lanes, but none there.
LaneMap mapAround(const NuScenesRecording& recording, const LaneMap& map, double radius) {
  std::vector<Vector2> points;
  for (const NuScenesEgoPose& pose : recording.ego_poses) {
    const Vector2 point = pose.translation.head<2>();
    constexpr double kSpacing = 5.0;  // m; closer points add nothing to the crop
    if (points.empty() || (point - points.back()).norm() > kSpacing) points.push_back(point);
  }
  LaneMap part = cropped(map, points, radius);
  if (part.lanes.empty() && !map.lanes.empty() && !points.empty()) {
    throw std::runtime_error(farWords(recording.ego_poses.front(), map, radius));
  }
  return part;
}

void writeScenarioNetFile(const Arguments& arguments, const Scene& scene, const Config& config,
                          PickleWorkers& workers) {
  writeText(resultPath(arguments, scene.name),
            workers.write(scenarioNetOf(scene, arguments.rows, config.exports)));
}

/// A bag of this suite has no LoggedScene, and its map is cut out already.
bool isFromOwnBag(const Arguments& arguments) {
  return arguments.to_scenario_net && arguments.logs.format == &bagFormat();
}

/// Returns what is left to say after the sensor data of a scene were written; empty: nothing.
std::string sensorWords(const SensorCounts& counts) {
  std::string words;
  const auto add = [&](std::size_t count, const char* file, const char* what) {
    if (count > 0) words += (words.empty() ? "" : ", ") + counted(count, file) + what;
  };
  add(counts.missing, "sensor file", " missing");
  add(counts.missing_can, "CAN bus file", " missing");
  add(counts.unreadable, "sensor file", " unreadable (not of its format)");
  return words;
}

/// Writes a scene of a bag of another stack, with its sensors.
void writeForeignBag(const Arguments& arguments, const NuScenesRecording& recording,
                     const LaneMap& map, const EgoVehicle& ego) {
  const std::filesystem::path source = arguments.logs.path;
  const std::filesystem::path bag =
      std::filesystem::is_directory(source) ? source / (recording.name + ".bag") : source;
  const OpenedBag opened(bag.string());
  writeBag(resultPath(arguments, recording.name), recording, map, nullptr, [&](NewBag& target) {
    copySensors(opened.bag(), readTopicMapping(arguments.topics), ego, target);
  });
}

void writeSceneBag(const Arguments& arguments, const LoggedScene& logged, const LaneMap& map,
                   const SensorScenes& sensors, const EgoVehicle& ego) {
  const NuScenesRecording& recording = logged.recording;
  const std::string path = resultPath(arguments, recording.name);
  if (arguments.sensors == SensorOrigin::kFiles && !arguments.topics.empty()) {
    writeForeignBag(arguments, recording, map, ego);
    return;
  }
  if (arguments.sensors == SensorOrigin::kSimulated) {
    const NuScenesSensorScene simulated = simulatedSensors(recording);
    writeBag(path, recording, map, &simulated);
    return;
  }
  const auto found = sensors.find(recording.name);
  const SensorCounts counts =
      writeBag(path, recording, map, found == sensors.end() ? nullptr : &found->second);
  const std::string words = sensorWords(counts);
  if (!words.empty()) printLine("warning: " + path + ": " + words);
}

void convertScene(const Arguments& arguments, const LoggedScene& logged, const Config& config,
                  const SensorScenes& sensors, PickleWorkers& workers) {
  LaneMap map = mapAround(logged.recording, logged.lanes->map(), config.conversion.map_radius);
  if (!arguments.to_scenario_net) {
    writeSceneBag(arguments, logged, map, sensors, config.ego_vehicle);
    return;
  }
  const Scene scene = toScene(logged.recording, config.ego_vehicle,
                              std::make_shared<const LaneMap>(std::move(map)));
  writeScenarioNetFile(arguments, scene, config, workers);
}

std::unique_ptr<SceneReader> openLogs(const Arguments& arguments, const Config& config) {
  const SceneReading reading{arguments.scenes, config, printWarnings, showReading()};
  if (arguments.topics.empty()) return arguments.logs.format->open(arguments.logs, reading);
  const std::filesystem::path source = std::filesystem::canonical(arguments.logs.path);
  const bool is_folder = std::filesystem::is_directory(source);
  if (std::filesystem::equivalent(is_folder ? source : source.parent_path(), arguments.out)) {
    throw std::runtime_error(arguments.out +
                             ": this folder holds the input bags; choose another --out");
  }
  return openForeignBags(
      arguments.logs.path,
      {readTopicMapping(arguments.topics), arguments.map, arguments.without_lanes}, reading);
}

/// Reads which sensor files the scenes have, and prints their number and size.
SensorScenes readSensors(const Arguments& arguments, const std::vector<std::string>& scenes) {
  if (arguments.sensors != SensorOrigin::kFiles || !arguments.topics.empty()) return {};
  if (arguments.logs.format != &nuScenesFormat()) {
    throw std::runtime_error(
        arguments.logs.described() +
        ": --sensors files needs a nuScenes root, or --topics; simulated works "
        "with all");
  }
  SensorScenes sensors =
      readNuScenesSensors(arguments.logs.path, versionOf(arguments.logs), scenes);
  std::uintmax_t bytes = 0;
  std::size_t files = 0;
  for (const auto& [_, scene] : sensors) {
    for (const NuScenesSensorFile& file : scene.files) {
      std::error_code missing;
      const std::uintmax_t size = std::filesystem::file_size(file.path, missing);
      if (missing) continue;
      bytes += size;
      ++files;
    }
  }
  std::cerr << counted(files, "sensor file") << " of " << bytes / 1000000 << " MB to convert\n";
  return sensors;
}

int convert(const Arguments& arguments) {
  const Config config = loadConfig(arguments.config);
  const OutputLocks locks = lockFolders({arguments.out});
  std::cerr << "reading " << arguments.logs.described() << "\n";
  const auto logs = openLogs(arguments, config);
  const std::vector<std::string> scenes = logs->names();
  const auto before = static_cast<std::size_t>(
      std::count_if(scenes.begin(), scenes.end(),
                    [&](const std::string& scene) { return isConverted(arguments, scene); }));
  std::cerr << counted(scenes.size() - before, "scene") << " to convert, " << before
            << " already converted\n";
  const SensorScenes sensors = readSensors(arguments, scenes);
  PickleWorkers workers;
  const auto convertOne = [&](std::size_t index) -> std::string {
    const std::string& scene = scenes[index];
    if (isConverted(arguments, scene)) return "";
    try {
      if (isFromOwnBag(arguments)) {
        writeScenarioNetFile(arguments, logs->read(scene).scene, config, workers);
      } else {
        convertScene(arguments, logs->recording(scene), config, sensors, workers);
      }
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
  dispatch(scenes.size(), convertOne, take, {arguments.jobs, 0});
  if (arguments.to_scenario_net) {
    writeScenarioNetSummary(arguments.out, scenarioNetNames(arguments.out), workers);
  }
  std::cerr << counted(scenes.size() - before - failures, "scene") << " written to "
            << arguments.out << "\n";
  return failures == 0 ? kExitOk : kExitError;
}

}  // namespace

void addConvert(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app = line.add(
      kMakingCollisions, "convert",
      "Converts recorded scenes to bags (poses, agents, lane map, markers) or to ScenarioNet.",
      [arguments] { return convert(*arguments); });
  addSource(app, arguments->logs)->required();
  CLI::Option* const topics =
      app.add_option("--topics", arguments->topics,
                     "topic mapping of third-party bags, e.g. config/topics_autoware.yaml")
          ->check(CLI::ExistingFile);
  CLI::Option* const map =
      app.add_option("--map", arguments->map,
                     "map file for third-party bags (docs/maps.md); default: /lane_map in each bag")
          ->check(CLI::ExistingFile)
          ->needs(topics);
  app.add_flag("--without-lanes", arguments->without_lanes,
               "convert third-party bags without lanes (docs/maps.md says which attacks need none)")
      ->needs(topics)
      ->excludes(map);
  addScenes(app, arguments->scenes);
  addOut(app, arguments->out, "output folder, one file per scene");
  addChoice<bool>(app, "--to", arguments->to_scenario_net, {{"bag", false}, {"scenarionet", true}},
                  "output format");
  addChoice<SensorOrigin>(
      app, "--sensors", arguments->sensors,
      {{"none", SensorOrigin::kNone},
       {"files", SensorOrigin::kFiles},
       {"simulated", SensorOrigin::kSimulated}},
      "sensor data in the bags; files: lidar, cameras, radar, GPS and IMU of a "
      "nuScenes root, or the sensors of bags with --topics; simulated: a lidar among "
      "the annotated objects (docs/lidar.md)");
  addChoice<RowTimes>(
      app, "--rows", arguments->rows,
      {{"even", RowTimes::kEveryStep}, {"recorded", RowTimes::kAsRecorded}},
      "times of the states in ScenarioNet files; even: every `step` of export.yaml, which "
      "MetaDrive needs; recorded: the recorded times, without loss");
  addJobs(app, arguments->jobs, "scenes converted in parallel");
  app.add_flag("--force", arguments->force, "also convert scenes whose output exists");
  addConfig(app, arguments->config);
}

}  // namespace forge
