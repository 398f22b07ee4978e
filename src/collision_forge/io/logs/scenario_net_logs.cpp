#include "collision_forge/io/logs/scenario_net_logs.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <unordered_set>
#include <utility>

#include "collision_forge/base/config/section.h"
#include "collision_forge/base/map/road_area.h"
#include "collision_forge/base/scene/input_limits.h"
#include "collision_forge/base/scene/map_limits.h"
#include "collision_forge/base/scene/number_words.h"
#include "collision_forge/base/scene/request_words.h"
#include "collision_forge/io/logs/pickle_field.h"
#include "collision_forge/io/logs/recording_repair.h"
#include "collision_forge/io/logs/scenario_net_lanes.h"
#include "collision_forge/io/logs/scenario_net_lights.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

constexpr double kEarliest = 1.0;      // s, earliest start of a scene
constexpr double kMicroseconds = 1e6;  // per second
constexpr double kLongestCar = 6.5;    // m; longer vehicles are trucks

std::int64_t microseconds(double seconds) { return std::llround(seconds * kMicroseconds); }

Eigen::Quaterniond turned(double yaw) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()));
}

/// Returns true for a type of MetaDrive, which says less than the length.
bool isType(const std::string& type) {
  return type == "VEHICLE" || type == "PEDESTRIAN" || type == "CYCLIST" || type == "OTHER";
}

/// Classes that metadata names: this package's own "class", or the category that ScenarioNet's
/// converters keep as "type".
std::optional<AgentClass> namedClass(const std::optional<PickleField>& metadata,
                                     const DataOptions& options) {
  if (!metadata) return std::nullopt;
  if (const auto given = metadata->find("class")) {
    if (const auto known = agentClassFromString(given->text())) return known;
    given->fail("\"" + given->text() + "\" is not a known agent class");
  }
  const auto type = metadata->find("type");
  if (!type || !type->isText() || isType(type->text())) return std::nullopt;
  return agentClassOfCategory(type->text(), options.categories);
}

AgentClass classOf(const std::string& type, const std::optional<PickleField>& metadata,
                   double length, const DataOptions& options) {
  if (const auto named = namedClass(metadata, options)) return *named;
  if (type == "VEHICLE") return length > kLongestCar ? AgentClass::kTruck : AgentClass::kCar;
  if (type == "PEDESTRIAN") return AgentClass::kPedestrian;
  if (type == "CYCLIST") return AgentClass::kBicycle;
  return AgentClass::kStaticObject;
}

/// Sizes for tracks without a size, m; chosen near the sizes of nuScenes.
BoxSize typicalSize(const std::string& type) {
  if (type == "PEDESTRIAN") return {0.73, 0.67};
  if (type == "CYCLIST") return {1.70, 0.60};
  if (type == "VEHICLE") return {4.62, 1.95};
  return {0.41, 0.41};
}

bool isSize(double value) { return std::isfinite(value) && value > 0.0; }

/// A track of the file with a state in each valid row with finite numbers. Its box is the median of
/// the sizes in such rows.
struct RecordedTrack {
  RecordedTrack(const std::string& id, const PickleField& field, const std::vector<double>& times,
                const DataOptions& options);

  Track track;
  double height = 0.0;              // m
  bool has_typical_size = false;    // the file has no size of it
  bool has_other_size = false;      // at first: isOtherSize()
  int dropped = 0;                  // valid rows with a number that is not finite
  std::vector<std::string> unused;  // messages about values that cannot be read
};

RecordedTrack::RecordedTrack(const std::string& id, const PickleField& field,
                             const std::vector<double>& times, const DataOptions& options) {
  const std::size_t rows = times.size();
  const PickleField state = field.at("state");
  const std::vector<Vector2> positions = state.at("position").pointRows(rows);
  if (positions.size() != rows) state.at("position").fail("has no rows");
  const std::vector<double> yaws = state.at("heading").column(rows);
  const std::vector<double> valid = state.at("valid").column(rows);
  const auto optional = [&](const char* key) {
    const auto read = [&](const PickleField& value) { return value.column(rows); };
    return state.find(key, unused, read).value_or(std::vector<double>(rows, 0.0));
  };
  const std::vector<double> lengths = optional("length");
  const std::vector<double> widths = optional("width");
  const std::vector<double> heights = optional("height");
  const auto read_points = [&](const PickleField& value) { return value.pointRows(rows); };
  const auto speeds = state.find("velocity", unused, read_points).value_or(std::vector<Vector2>());
  track.id = id;
  std::vector<Eigen::Vector3d> sizes;
  for (std::size_t row = 0; row < rows; ++row) {
    if (std::isnan(valid[row]) || valid[row] == 0.0) continue;
    if (!std::isfinite(yaws[row]) || !positions[row].allFinite()) {
      ++dropped;
      continue;
    }
    if (isSize(lengths[row]) && isSize(widths[row])) {
      sizes.emplace_back(lengths[row], widths[row], isSize(heights[row]) ? heights[row] : 0.0);
    }
    const bool has_speed = !speeds.empty() && speeds[row].allFinite();
    track.states.push_back({times[row],
                            {positions[row].x(), positions[row].y(), wrapAngle(yaws[row])},
                            has_speed ? speeds[row] : Vector2(0.0, 0.0)});
  }
  const std::string type = field.at("type").text();
  has_typical_size = sizes.empty();
  if (has_typical_size) {
    track.size = typicalSize(type);
  } else {
    const Eigen::Vector3d median = medianSize(sizes);
    track.size = {median.x(), median.y()};
    height = median.z();
    if (height > 0.0) track.height = height;
    has_other_size = isOtherSize(sizes.front(), median);
  }
  if (speeds.empty()) deriveVelocities(track);
  track.agent_class = classOf(type, field.find("metadata"), track.size.length, options);
}

DrivingSide sideOf(const std::optional<PickleField>& own, const std::string& location,
                   const DataOptions& options) {
  if (const auto side = own ? own->find("driving_side") : std::nullopt) {
    return side->text() == "left" ? DrivingSide::kLeft : DrivingSide::kRight;
  }
  try {
    return drivingSide(options, location);
  } catch (const ConfigError&) {
    return DrivingSide::kRight;  // as in nearly all data sets that ScenarioNet converts
  }
}

std::string nameOf(const fs::path& file) {
  const std::string stem = file.stem().string();
  const std::string own = kOwnDescriptions;
  return stem.rfind(own, 0) == 0 && stem.size() > own.size() ? stem.substr(own.size()) : stem;
}

class DescriptionReader {
 public:
  DescriptionReader(const std::string& path, PickleWorkers& workers, const DataOptions& options,
                    std::vector<std::string>* warnings)
      : options_(options),
        warnings_(warnings),
        path_(path),
        root_(path, workers.read(path)),
        metadata_(root_.at("metadata")),
        own_(metadata_.find("collision_forge")) {}

  LoggedScene read() {
    readTimes();
    LoggedScene logged;
    NuScenesRecording& recording = logged.recording;
    recording.name = nameOf(path_);
    const auto place = metadata_.find("map");
    if (place && place->isText()) recording.location = place->text();
    readTracks(recording);
    logged.lanes = std::make_shared<const LaneIndex>(
        std::make_shared<const LaneMap>(readMap(recording.location)));
    if (const auto states = root_.find("dynamic_map_states")) {
      std::vector<std::string> problems;
      recording.lights = lightsOf(*states, times_, logged.lanes->map(), problems);
      warnOfProblems(problems, "traffic light");
    }
    return logged;
  }

 private:
  void readTimes() {
    const PickleField field = metadata_.at("ts");
    times_ = field.column();
    for (std::size_t i = 0; i < times_.size(); ++i) {
      if (std::isfinite(times_[i]) && (i == 0 || times_[i] > times_[i - 1])) continue;
      field.fail("row " + std::to_string(i) + " is not after the previous time");
    }
    if (times_.size() < 2) field.fail("has fewer than two times");
    const auto start = own_ ? own_->find("start") : std::nullopt;
    const double first = (start ? start->number() : 0.0) + times_.front();
    const double shift = std::max(first, kEarliest) - times_.front();
    frame_times_ = times_;
    if (const auto frames = own_ ? own_->find("frame_times") : std::nullopt) {
      frame_times_ = frames->column();
    }
    for (double& time : times_) time += shift;
    for (double& time : frame_times_) time += shift;
  }

  void readTracks(NuScenesRecording& recording) {
    for (const double time : frame_times_) {
      recording.frames.push_back({"", microseconds(time), {}});
    }
    const std::string ego = metadata_.at("sdc_id").word();
    const PickleField tracks = root_.at("tracks");
    const auto own = tracks.find(ego.c_str());
    if (!own) tracks.fail("lacks the ego \"" + ego + "\" of metadata.sdc_id");
    std::vector<std::string> unused;
    const RecordedTrack recorded_ego(ego, *own, times_, options_);
    addEgo(recorded_ego, recording);
    unused.insert(unused.end(), recorded_ego.unused.begin(), recorded_ego.unused.end());
    if (recording.ego_poses.empty()) tracks.fail("the ego is valid in no row");
    std::vector<std::string> without_size;
    std::vector<std::string> other_size;
    std::vector<std::string> unreadable;
    for (const auto& [id, field] : tracks.entries()) {
      if (id == ego) continue;
      try {
        const RecordedTrack recorded(id, field, times_, options_);
        if (recorded.has_typical_size) without_size.push_back(id);
        if (recorded.has_other_size) other_size.push_back(id);
        warnOfDropped(recorded);
        unused.insert(unused.end(), recorded.unused.begin(), recorded.unused.end());
        addAgent(recorded, recording);
      } catch (const std::runtime_error& error) {
        unreadable.push_back(error.what());
      }
    }
    if (!without_size.empty()) {
      warn(counted(without_size.size(), "agent") + " without a size (first: " +
           without_size.front() + "): the typical size of the type is used");
    }
    if (!other_size.empty()) warn(sizeWarning(other_size));
    warnOfProblems(unreadable, "agent");
    warnOfUnused(unused);
  }

  void warnOfProblems(const std::vector<std::string>& problems, const char* what) {
    if (problems.empty()) return;
    warn(counted(problems.size(), what) +
         " that cannot be read left out (first: " + problems.front() + ")");
  }

  void warnOfUnused(const std::vector<std::string>& problems) {
    if (problems.empty()) return;
    warn(counted(problems.size(), "value") +
         " that cannot be read not used (first: " + problems.front() + ")");
  }

  void warnOfDropped(const RecordedTrack& recorded) {
    if (recorded.dropped == 0) return;
    warn(recorded.track.id + ": " + counted(static_cast<std::size_t>(recorded.dropped), "state") +
         " with a number that is not finite left out");
  }

  void addEgo(RecordedTrack recorded, NuScenesRecording& recording) {
    BoxSize& size = recorded.track.size;
    warnOfDropped(recorded);
    if (size.width > size.length) {
      std::swap(size.width, size.length);
      warn("the ego is wider than long: length and width are swapped");
    }
    if (!recorded.has_typical_size) recording.ego_size = size;
    for (const AgentState& state : recorded.track.states) {
      const Pose2 base = compose(state.pose, {-options_.ego_vehicle.center_offset, 0.0, 0.0});
      recording.ego_poses.push_back(
          {microseconds(state.time), {base.x, base.y, 0.0}, turned(base.yaw)});
    }
  }

  void addAgent(const RecordedTrack& recorded, NuScenesRecording& recording) {
    const Track& track = recorded.track;
    for (std::size_t i = 0; i < frame_times_.size(); ++i) {
      const bool is_row = std::binary_search(times_.begin(), times_.end(), frame_times_[i]);
      const auto state = stateAt(track, frame_times_[i], is_row ? 0.0 : kMaxGap);
      if (!state) continue;
      NuScenesAnnotation annotation;
      annotation.instance = track.id;
      annotation.category = categoryOf(track.agent_class);
      annotation.translation = {state->pose.x, state->pose.y, 0.5 * recorded.height};
      annotation.size = {track.size.length, track.size.width, recorded.height};
      annotation.rotation = turned(state->pose.yaw);
      annotation.velocity = {state->velocity.x(), state->velocity.y(), 0.0};
      recording.frames[i].annotations.push_back(std::move(annotation));
    }
  }

  LaneMap readMap(const std::string& location) {
    FeatureProblems problems;
    const auto read = [&](const PickleField& features) { return lanesOf(features, problems); };
    LaneMap map = root_.find("map_features", problems.left_out, read).value_or(LaneMap());
    warnOfProblems(problems.left_out, "map feature");
    warnOfUnused(problems.unused);
    map.location = location;
    map.driving_side = sideOf(own_, location, options_);
    const auto areas = own_ ? own_->find("drivable_area") : std::nullopt;
    if (areas) map.drivable_area = areasOf(*areas);
    keepWithin(map, options_.input_limits, warnings_);
    if (!areas) map.drivable_area = roadArea(map.features, map.lanes);
    if (map.drivable_area.empty()) {
      for (const Lane& lane : map.lanes) {
        if (lane.polygon.size() >= 3) map.drivable_area.push_back({lane.polygon, {}});
      }
    }
    if (map.lanes.empty()) {
      warn("no lane in map_features: requests need --believable false, and no vehicle is added");
    }
    checkMap(map, options_.input_limits, path_);
    return map;
  }

  void warn(const std::string& what) {
    if (warnings_ != nullptr) warnings_->push_back(what);
  }

  const DataOptions& options_;
  std::vector<std::string>* warnings_;
  std::string path_;
  PickleField root_;
  PickleField metadata_;
  std::optional<PickleField> own_;  // fields of this package that the format does not define
  std::vector<double> times_;       // of the rows, s
  std::vector<double> frame_times_;
};

bool isDescription(const fs::path& path) {
  return path.extension() == ".pkl" && path.filename().string().rfind("sd_", 0) == 0;
}

/// Returns the paths of the descriptions by scene name.
std::map<std::string, std::string> descriptionsIn(const std::string& folder) {
  std::map<std::string, std::string> found;
  std::error_code ignored;
  for (const auto& entry : fs::recursive_directory_iterator(folder, ignored)) {
    if (!isDescription(entry.path())) continue;
    const std::string path = entry.path().string();
    const auto [same, is_new] = found.emplace(nameOf(entry.path()), path);
    if (!is_new) throw std::runtime_error(path + ": has the same scene name as " + same->second);
  }
  return found;
}

bool hasDescriptions(const std::string& path) {
  std::error_code ignored;
  const fs::recursive_directory_iterator entries(path, ignored);
  return std::any_of(begin(entries), end(entries),
                     [](const auto& entry) { return isDescription(entry.path()); });
}

std::vector<std::string> namesIn(const LogSource& source) {
  std::vector<std::string> names;
  for (const auto& [name, path] : descriptionsIn(source.path)) names.push_back(name);
  return names;
}

class ScenarioNetLogs : public SceneReader {
 public:
  ScenarioNetLogs(const LogSource& source, SceneReading reading)
      : reading_(std::move(reading)),
        names_(wantedScenes(source, reading_.scenes)),
        paths_(descriptionsIn(source.path)) {}

  std::vector<std::string> names() const override { return names_; }

  LoggedScene recording(const std::string& name) override {
    std::vector<std::string> warnings;
    LoggedScene logged = readScenarioNet(paths_.at(name), workers_, reading_.options, &warnings);
    if (reading_.on_warnings && !warnings.empty()) reading_.on_warnings(name, warnings);
    return logged;
  }

  IndexedScene read(const std::string& name) override {
    return flattened(recording(name), reading_);
  }

 private:
  SceneReading reading_;
  std::vector<std::string> names_;
  std::map<std::string, std::string> paths_;
  PickleWorkers workers_;
};

std::unique_ptr<SceneReader> openScenarioNet(const LogSource& source, const SceneReading& reading) {
  return std::make_unique<ScenarioNetLogs>(source, reading);
}

}  // namespace

const LogFormat& scenarioNetFormat() {
  static const LogFormat format{"a ScenarioNet folder", hasDescriptions, namesIn, openScenarioNet};
  return format;
}

LoggedScene readScenarioNet(const std::string& path, PickleWorkers& workers,
                            const DataOptions& options, std::vector<std::string>* warnings) {
  LoggedScene logged = DescriptionReader(path, workers, options, warnings).read();
  keepWithin(logged.recording, options, warnings);
  return logged;
}

}  // namespace forge
