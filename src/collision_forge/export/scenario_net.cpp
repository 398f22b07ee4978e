#include "collision_forge/export/scenario_net.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>
#include <unordered_set>

#include "collision_forge/export/drivable_edge.h"
#include "collision_forge/export/pickle_writer.h"
#include "collision_forge/files/aside_file.h"
#include "collision_forge/files/plain_name.h"
#include "collision_forge/map/lane_map.h"

namespace forge {
namespace {

// What the names of files are made of, as the format wants it.
constexpr const char* kDataset = "collision_forge";
constexpr const char* kVersion = "v1";

constexpr const char* kMetadata = "metadata";
constexpr std::size_t kAfterMetadata = 2;  // bytes of a file: the end of its dict, and its own

constexpr double kLongestCone = 1.0;       // m; static objects that are longer are barriers
constexpr double kLeastDistance = 1.0;     // m; what drives less does not count as moving
constexpr double kMostApart = 100.0;       // m between the middles of a lane's line and its outline
constexpr double kKilometresAnHour = 3.6;  // in a metre a second

/// What a crash's metadata begin with.
PickleWriter begunMetadata() {
  PickleWriter metadata;
  metadata.text("dataset", kDataset);
  return metadata;
}

std::string fileOf(const std::string& name) {
  return std::string("sd_") + kDataset + "_" + kVersion + "_" + name + ".pkl";
}

const char* typeOf(const Track& track) {
  switch (track.agent_class) {
    case AgentClass::kMotorcycle:
    case AgentClass::kBicycle:
      return "CYCLIST";
    case AgentClass::kPedestrian:
      return "PEDESTRIAN";
    case AgentClass::kAnimal:
      return "OTHER";
    case AgentClass::kStaticObject:
      return std::max(track.size.length, track.size.width) > kLongestCone ? "TRAFFIC_BARRIER"
                                                                          : "TRAFFIC_CONE";
    default:
      return "VEHICLE";
  }
}

std::vector<const Track*> tracksOf(const CrashRecord& record) {
  std::vector<const Track*> tracks{&record.ego, &record.attacker};
  for (const Track& track : record.others) tracks.push_back(&track);
  return tracks;
}

/// A track's states, a row a step of the record; zeros where it is not seen.
struct StateRows {
  StateRows(const Track& track, const CrashRecord& record);

  std::vector<double> positions;  ///< x, y, z
  std::vector<double> headings;
  std::vector<double> velocities;  ///< x, y
  std::vector<bool> seen;
};

StateRows::StateRows(const Track& track, const CrashRecord& record) {
  const std::size_t count = record.ego.states.size();
  positions.resize(3 * count);
  headings.resize(count);
  velocities.resize(2 * count);
  seen.resize(count);
  for (const AgentState& state : track.states) {
    const auto row = static_cast<std::size_t>(std::lround(state.time / record.step));
    positions.at(3 * row) = state.pose.x;
    positions.at(3 * row + 1) = state.pose.y;
    headings.at(row) = state.pose.yaw;
    velocities.at(2 * row) = state.velocity.x();
    velocities.at(2 * row + 1) = state.velocity.y();
    seen.at(row) = true;
  }
}

void writeTrack(PickleWriter& writer, const Track& track, const CrashRecord& record,
                double height) {
  const StateRows rows(track, record);
  const auto whereSeen = [&](double value) {
    std::vector<double> values;
    for (const bool is_seen : rows.seen) values.push_back(is_seen ? value : 0.0);
    return values;
  };
  writer.beginDict(track.id);
  writer.text("type", typeOf(track));
  writer.beginDict("state");
  writer.numbers("position", rows.positions, 3);
  writer.numbers("heading", rows.headings);
  writer.numbers("velocity", rows.velocities, 2);
  writer.numbers("length", whereSeen(track.size.length));
  writer.numbers("width", whereSeen(track.size.width));
  writer.numbers("height", whereSeen(height));
  writer.flags("valid", rows.seen);
  writer.endDict();
  writer.beginDict("metadata");
  writer.text("type", typeOf(track));
  writer.text("class", toString(track.agent_class));
  writer.text("object_id", track.id);
  writer.count("track_length", rows.seen.size());
  writer.endDict();
  writer.endDict();
}

void writeTracks(PickleWriter& writer, const CrashRecord& record, const ExportOptions& options) {
  writer.beginDict("tracks");
  for (const Track* track : tracksOf(record)) {
    writeTrack(writer, *track, record, options.heights.at(track->agent_class));
  }
  writer.endDict();
}

std::vector<double> flat(const std::vector<Vector2>& points) {
  std::vector<double> numbers;
  for (const Vector2& point : points) numbers.insert(numbers.end(), {point.x(), point.y()});
  return numbers;
}

Vector2 middleOf(const std::vector<Vector2>& points) {
  Vector2 sum(0.0, 0.0);
  for (const Vector2& point : points) sum += point;
  return sum / static_cast<double>(points.size());
}

/// Writes the parts of a map that are near.
class MapWriter {
 public:
  MapWriter(PickleWriter& writer, const CrashRecord& record) : writer_(writer), record_(record) {
    for (const Lane& lane : record.lanes.lanes) {
      if (lane.centerline.size() > 1) lanes_.insert(lane.id);
    }
  }

  /// Returns how many there are.
  std::size_t write(double radius) {
    writer_.beginDict("map_features");
    for (const Lane& lane : record_.lanes.lanes) writeLane(lane);
    for (const Polygon& walkway : record_.lanes.walkways) writeWalkway(walkway);
    for (const auto& line : drivableEdges(record_.lanes.drivable_area, ways(), radius)) {
      beginFeature("edge_", "ROAD_EDGE_BOUNDARY");
      writer_.numbers("polyline", flat(line), 2);
      writer_.endDict();
    }
    writer_.endDict();
    return lanes_.size() + others_;
  }

 private:
  /// Where ego and attacker are.
  std::vector<Vector2> ways() const {
    std::vector<Vector2> places;
    for (const Track* track : {&record_.ego, &record_.attacker}) {
      for (const AgentState& state : track->states) places.push_back(state.pose.position());
    }
    return places;
  }

  void beginFeature(const char* kind, const char* type) {
    writer_.beginDict(kind + std::to_string(others_++));
    writer_.text("type", type);
  }

  void writeWalkway(const Polygon& walkway) {
    beginFeature("walkway_", "ROAD_EDGE_SIDEWALK");
    writer_.numbers("polygon", flat(walkway.exterior), 2);
    writer_.endDict();
  }

  std::vector<std::string> known(const std::vector<std::string>& ids) const {
    std::vector<std::string> found;
    for (const std::string& id : ids) {
      if (lanes_.count(id) != 0) found.push_back(id);
    }
    return found;
  }

  void writeLane(const Lane& lane) {
    if (lanes_.count(lane.id) == 0) return;
    std::vector<Vector2> line;
    for (const Pose2& pose : lane.centerline) line.push_back(pose.position());
    writer_.beginDict(lane.id);
    writer_.text("type", lane.is_connector ? "LANE_SURFACE_UNSTRUCTURE" : "LANE_SURFACE_STREET");
    writer_.numbers("polyline", flat(line), 2);
    const bool is_outlined = !lane.polygon.empty();
    if (is_outlined && (middleOf(line) - middleOf(lane.polygon)).norm() < kMostApart) {
      writer_.numbers("polygon", flat(lane.polygon), 2);
    }
    writer_.texts("entry_lanes", known(lane.incoming));
    writer_.texts("exit_lanes", known(lane.outgoing));
    writer_.texts("left_neighbor", {});  // not known, as in ScenarioNet's own of nuScenes
    writer_.texts("right_neighbor", {});
    if (lane.speed_limit) {
      writer_.number("speed_limit_kmh", kKilometresAnHour * *lane.speed_limit);
    }
    writer_.endDict();
  }

  PickleWriter& writer_;
  const CrashRecord& record_;
  std::unordered_set<std::string> lanes_;  // ids of those with a line
  std::size_t others_ = 0;                 // features that are no lanes
};

/// m, from each state to the next.
double distanceOf(const Track& track) {
  double distance = 0.0;
  for (std::size_t i = 1; i < track.states.size(); ++i) {
    const Vector2 before = track.states[i - 1].pose.position();
    distance += (track.states[i].pose.position() - before).norm();
  }
  return distance;
}

void writeObjectSummary(PickleWriter& metadata, const CrashRecord& record) {
  metadata.beginDict("object_summary");
  for (const Track* track : tracksOf(record)) {
    metadata.beginDict(track->id);
    metadata.text("type", typeOf(*track));
    metadata.text("object_id", track->id);
    metadata.count("track_length", record.ego.states.size());
    metadata.number("moving_distance", distanceOf(*track));
    metadata.count("valid_length", track->states.size());
    metadata.count("continuous_valid_length", seenStretches(*track, record.step).front().size());
    metadata.endDict();
  }
  metadata.endDict();
}

using TypeCounts = std::map<std::string, std::size_t>;

void writeCounts(PickleWriter& metadata, const std::string& of_all, const TypeCounts& counts) {
  std::size_t sum = 0;
  metadata.beginDict(of_all + "_each_type");
  for (const auto& [type, count] : counts) {
    metadata.count(type, count);
    sum += count;
  }
  metadata.endDict();
  metadata.count(of_all, sum);
}

void writeNumberSummary(PickleWriter& metadata, const CrashRecord& record, std::size_t features) {
  TypeCounts all;
  TypeCounts moving;
  std::vector<std::string> types;
  for (const Track* track : tracksOf(record)) {
    if (++all[typeOf(*track)] == 1) types.emplace_back(typeOf(*track));
    if (distanceOf(*track) > kLeastDistance) ++moving[typeOf(*track)];
  }
  metadata.beginDict("number_summary");
  metadata.texts("object_types", types);
  writeCounts(metadata, "num_objects", all);
  writeCounts(metadata, "num_moving_objects", moving);
  metadata.count("num_traffic_lights", 0);
  metadata.texts("num_traffic_light_types", {});
  metadata.beginDict("num_traffic_light_each_step");
  metadata.endDict();
  metadata.count("num_map_features", features);
  metadata.number("map_height_diff", 0.0);
  metadata.endDict();
}

void writeCrash(PickleWriter& metadata, const CrashRecord& record) {
  const SceneRequest& asked = record.scenario.asked;
  const Realization& answer = record.scenario.answer;
  metadata.beginDict("collision_forge");
  metadata.text("scene", asked.scene);
  metadata.text("type", toString(asked.request.type));
  metadata.text("mode", toString(asked.request.mode));
  metadata.number("tta", asked.request.tta);
  metadata.count("seed", asked.request.seed);
  metadata.text("manoeuvre", toString(answer.report.manoeuvre));
  metadata.text("attacker", record.attacker.id);
  metadata.flag("attacker_is_added", answer.trajectory.isAdded());
  metadata.number("now", record.now);
  if (record.contact) {
    metadata.number("contact_time", *record.contact);
  } else {
    metadata.none("contact_time");
  }
  metadata.endDict();
}

PickleWriter metadataOf(const CrashRecord& record, std::size_t features) {
  PickleWriter metadata = begunMetadata();
  metadata.text("id", record.name);
  metadata.text("scenario_id", record.name);
  metadata.text("map", record.lanes.location);
  metadata.text("coordinate", "metadrive");
  metadata.flag("metadrive_processed", false);
  metadata.number("sample_rate", record.step);
  std::vector<double> times;
  for (const AgentState& state : record.ego.states) times.push_back(state.time);
  metadata.numbers("ts", times);
  metadata.count("current_time_index",
                 static_cast<std::size_t>(std::lround(record.now / record.step)));
  metadata.text("sdc_id", record.ego.id);
  writeObjectSummary(metadata, record);
  writeNumberSummary(metadata, record, features);
  writeCrash(metadata, record);
  return metadata;
}

std::string scenarioOf(const CrashRecord& record, const ExportOptions& options) {
  PickleWriter writer;
  writer.text("id", record.name);
  writer.text("version", kVersion);
  writer.count("length", record.ego.states.size());
  writeTracks(writer, record, options);
  writer.beginDict("dynamic_map_states");
  writer.endDict();
  const std::size_t features = MapWriter(writer, record).write(options.radius);
  writer.value(kMetadata, metadataOf(record, features).dict());
  return writer.pickle();
}

/// The metadata of a scenario's file as its bytes, which are the file's last.
std::string metadataIn(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  const std::string key = pickledText(kMetadata);
  std::string begin = key + begunMetadata().dict();
  begin.pop_back();  // where the dict ends
  const std::size_t place = bytes.rfind(begin);
  if (place == std::string::npos) throw std::runtime_error(path + ": is no scenario of this suite");
  const std::size_t from = place + key.size();
  return bytes.substr(from, bytes.size() - kAfterMetadata - from);
}

class ScenarioNetWriter : public CrashWriter {
 public:
  explicit ScenarioNetWriter(const ExportPlan& plan) : plan_(plan) {}

  std::vector<std::string> write(const CrashRecord& record) const override {
    const std::string file = fileOf(record.name);
    writeText(pathOf(file), scenarioOf(record, plan_.options));
    return {file};
  }

  void finish(const std::vector<ExportedCrash>& crashes) const override {
    PickleWriter summary;
    PickleWriter folders;
    for (const ExportedCrash& crash : crashes) {
      const std::string file = fileOf(crash.name);
      summary.value(file, metadataIn(pathOf(file)));
      folders.text(file, "");
    }
    writeText(pathOf("dataset_summary.pkl"), summary.pickle());
    writeText(pathOf("dataset_mapping.pkl"), folders.pickle());
  }

 private:
  std::string pathOf(const std::string& file) const { return pathIn(plan_.folder, file); }

  ExportPlan plan_;
};

}  // namespace

std::unique_ptr<CrashWriter> makeScenarioNetWriter(const ExportPlan& plan) {
  if (plan.ego_free) {
    throw std::invalid_argument(
        "format scenarionet has no free ego: its tracks have a state at every step; who replays "
        "them may leave the ego's out");
  }
  return std::make_unique<ScenarioNetWriter>(plan);
}

}  // namespace forge
