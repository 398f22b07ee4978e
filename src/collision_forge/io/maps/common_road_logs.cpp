#include "collision_forge/io/maps/common_road_logs.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "collision_forge/base/scene/input_limits.h"
#include "collision_forge/base/scene/map_limits.h"
#include "collision_forge/io/maps/common_road_file.h"
#include "collision_forge/io/maps/common_road_map.h"
#include "collision_forge/io/maps/map_error.h"
#include "collision_forge/io/maps/xml_input.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

constexpr double kStart = 1.0;         // s, time of step 0
constexpr double kMicroseconds = 1e6;  // per second
constexpr double kSamePlace = 1.0;     // m between an ego and the start of its planning problem

std::int64_t microseconds(double seconds) { return std::llround(seconds * kMicroseconds); }

Eigen::Quaterniond turned(double yaw) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()));
}

/// Returns the distance (m) from the track to a planning problem's start at its time; infinite if
/// the track has no state then.
double distanceAt(const Track& track, const AgentState& start) {
  const auto state = stateAt(track, start.time);
  if (!state) return std::numeric_limits<double>::infinity();
  return (state->pose.position() - start.pose.position()).norm();
}

/// Returns the distance (m) of the track's first state from the nearest start of a problem; 0
/// without a problem.
double distanceFromStart(const Track& track, const std::vector<AgentState>& starts) {
  double distance = starts.empty() ? 0.0 : std::numeric_limits<double>::infinity();
  for (const AgentState& start : starts) {
    const Vector2& first = track.states.front().pose.position();
    distance = std::min(distance, (first - start.pose.position()).norm());
  }
  return distance;
}

class EgoChoice {
 public:
  EgoChoice(const CommonRoadFile& file, const std::string& path) : file_(file), path_(path) {}

  const Track& named(const std::string& id) const {
    for (const CommonRoadObstacle& obstacle : file_.obstacles) {
      if (!obstacle.is_static && obstacle.track.id == id) return obstacle.track;
    }
    throw MapError(path_ + ": has no dynamic obstacle " + id + " with a trajectory");
  }

  const Track& byRule(std::vector<std::string>* warnings) const {
    std::vector<const Track*> vehicles;
    for (const CommonRoadObstacle& obstacle : file_.obstacles) {
      const bool can_be_ego = !obstacle.is_static && isCarLike(obstacle.track.agent_class);
      if (can_be_ego) vehicles.push_back(&obstacle.track);
    }
    if (vehicles.empty()) {
      throw MapError(path_ + ": has no dynamic obstacle that can be the ego: none is a car, " +
                     "truck or bus with a trajectory");
    }
    for (const AgentState& start : file_.problem_starts) {
      for (const Track* const vehicle : vehicles) {
        if (distanceAt(*vehicle, start) <= kSamePlace) return *vehicle;
      }
    }
    const auto rank = [&](const Track* track) {
      const double seconds = track->states.back().time - track->states.front().time;
      return std::pair(-std::lround(seconds / file_.step),
                       distanceFromStart(*track, file_.problem_starts));
    };
    const Track& best =
        **std::min_element(vehicles.begin(), vehicles.end(),
                           [&](const Track* a, const Track* b) { return rank(a) < rank(b); });
    if (warnings != nullptr) {
      warnings->push_back("no obstacle drives from the start of a planning problem; the ego is " +
                          best.id +
                          ", in sight for the longest time; --ego-obstacle names another");
    }
    return best;
  }

 private:
  const CommonRoadFile& file_;
  const std::string& path_;
};

class RecordingBuilder {
 public:
  RecordingBuilder(const CommonRoadFile& file, const Track& ego, const DataOptions& options)
      : file_(file), ego_(ego), options_(options) {}

  NuScenesRecording build() {
    recording_.ego_size = ego_.size;
    for (const AgentState& state : ego_.states) {
      const Pose2 base = compose(state.pose, {-options_.ego_vehicle.center_offset, 0.0, 0.0});
      const std::int64_t time = microseconds(kStart + state.time);
      recording_.ego_poses.push_back({time, {base.x, base.y, 0.0}, turned(base.yaw)});
      recording_.frames.push_back({"", time, {}});
    }
    for (const CommonRoadObstacle& obstacle : file_.obstacles) {
      if (&obstacle.track != &ego_) addAgent(obstacle);
    }
    return std::move(recording_);
  }

 private:
  void addAgent(const CommonRoadObstacle& obstacle) {
    const Track& track = obstacle.track;
    for (std::size_t i = 0; i < ego_.states.size(); ++i) {
      if (obstacle.is_static) {
        add(track, {0.0, track.states.front().pose, Vector2::Zero()}, recording_.frames[i]);
      } else if (const auto state = stateAt(track, ego_.states[i].time)) {
        add(track, *state, recording_.frames[i]);
      }
    }
  }

  static void add(const Track& track, const AgentState& state, NuScenesFrame& frame) {
    NuScenesAnnotation annotation;
    annotation.instance = track.id;
    annotation.category = categoryOf(track.agent_class);
    annotation.translation = {state.pose.x, state.pose.y, 0.0};
    annotation.size = {track.size.length, track.size.width, 0.0};  // the format has no heights
    annotation.rotation = turned(state.pose.yaw);
    annotation.velocity = {state.velocity.x(), state.velocity.y(), 0.0};
    frame.annotations.push_back(std::move(annotation));
  }

  const CommonRoadFile& file_;
  const Track& ego_;
  const DataOptions& options_;
  NuScenesRecording recording_;
};

bool isScenario(const fs::path& path) {
  if (path.extension() != ".xml" || !fs::is_regular_file(path)) return false;
  try {
    return rootOf(path.string()) == "<commonRoad>";
  } catch (const MapError&) {
    return false;
  }
}

/// Returns the paths of the scenarios by scene name.
std::map<std::string, std::string> scenariosAt(const std::string& path) {
  std::map<std::string, std::string> found;
  if (isScenario(path)) found[fs::path(path).stem().string()] = path;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(path, ignored)) {
    if (isScenario(entry.path())) found[entry.path().stem().string()] = entry.path().string();
  }
  return found;
}

bool hasScenarios(const std::string& path) { return !scenariosAt(path).empty(); }

std::vector<std::string> namesIn(const LogSource& source) {
  std::vector<std::string> names;
  for (const auto& [name, path] : scenariosAt(source.path)) names.push_back(name);
  return names;
}

class CommonRoadLogs : public SceneReader {
 public:
  CommonRoadLogs(const LogSource& source, SceneReading reading)
      : reading_(std::move(reading)),
        ego_(source.ego),
        names_(wantedScenes(source, reading_.scenes)),
        paths_(scenariosAt(source.path)) {}

  std::vector<std::string> names() const override { return names_; }

  LoggedScene recording(const std::string& name) override {
    std::vector<std::string> warnings;
    LoggedScene logged = readCommonRoadScenario(paths_.at(name), ego_, reading_.options, &warnings);
    if (reading_.on_warnings && !warnings.empty()) reading_.on_warnings(name, warnings);
    return logged;
  }

  IndexedScene read(const std::string& name) override {
    return flattened(recording(name), reading_);
  }

 private:
  SceneReading reading_;
  std::string ego_;
  std::vector<std::string> names_;
  std::map<std::string, std::string> paths_;
};

std::unique_ptr<SceneReader> openScenarios(const LogSource& source, const SceneReading& reading) {
  return std::make_unique<CommonRoadLogs>(source, reading);
}

}  // namespace

const LogFormat& commonRoadFormat() {
  static const LogFormat format{"CommonRoad scenarios", hasScenarios, namesIn, openScenarios};
  return format;
}

LoggedScene readCommonRoadScenario(const std::string& path, const std::string& ego,
                                   const DataOptions& options, std::vector<std::string>* warnings) {
  WarningCounter counter;
  const CommonRoadFile file = readCommonRoadFile(path, options, counter);
  const std::string name = fs::path(path).stem().string();
  const EgoChoice choice(file, path);
  const Track& track = ego.empty() ? choice.byRule(warnings) : choice.named(ego);
  LoggedScene logged;
  logged.recording = RecordingBuilder(file, track, options).build();
  logged.recording.name = name;
  logged.recording.location = name;
  auto map = std::make_shared<LaneMap>(commonRoadLanes(file, name, options, counter));
  keepWithin(*map, options.input_limits, warnings);
  checkMap(*map, options.input_limits, path);
  logged.lanes = std::make_shared<const LaneIndex>(std::move(map));
  keepWithin(logged.recording, options, warnings);
  if (warnings != nullptr) {
    for (std::string& line : counter.lines(path)) warnings->push_back(std::move(line));
  }
  return logged;
}

}  // namespace forge
