#include "collision_forge/io/export/scenario_net_tracks.h"

#include <algorithm>
#include <map>
#include <string>

namespace forge {
namespace {

constexpr double kLongestCone = 1.0;    // m; longer static objects are barriers
constexpr double kLeastDistance = 1.0;  // m; shorter motion does not count as moving

const char* typeOf(const Track& track) {
  switch (track.agent_class) {
    case AgentClass::kMotorcycle:
    case AgentClass::kBicycle:
    case AgentClass::kScooter:
      return "CYCLIST";
    case AgentClass::kPedestrian:
    case AgentClass::kChild:
    case AgentClass::kRunner:
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

std::size_t rowOf(const AgentState& state, const std::vector<double>& times) {
  const auto found = std::lower_bound(times.begin(), times.end(), state.time);
  return static_cast<std::size_t>(found - times.begin());
}

/// A track's states, one row per time; zeros in rows without a state.
struct StateRows {
  StateRows(const Track& track, const std::vector<double>& times);

  std::vector<double> positions;  ///< x, y, z
  std::vector<double> headings;
  std::vector<double> velocities;  ///< x, y
  std::vector<bool> seen;
};

StateRows::StateRows(const Track& track, const std::vector<double>& times) {
  const std::size_t count = times.size();
  positions.resize(3 * count);
  headings.resize(count);
  velocities.resize(2 * count);
  seen.resize(count);
  for (const AgentState& state : track.states) {
    const std::size_t row = rowOf(state, times);
    positions.at(3 * row) = state.pose.x;
    positions.at(3 * row + 1) = state.pose.y;
    headings.at(row) = state.pose.yaw;
    velocities.at(2 * row) = state.velocity.x();
    velocities.at(2 * row + 1) = state.velocity.y();
    seen.at(row) = true;
  }
}

void writeTrack(PickleWriter& writer, const Track& track, const std::vector<double>& times,
                double height) {
  const StateRows rows(track, times);
  const auto whereSeen = [&](double value) {
    std::vector<double> values;
    for (const bool is_seen : rows.seen) values.push_back(is_seen ? value : 0.0);
    return values;
  };
  writer.beginObject(track.id.c_str());
  writer.text("type", typeOf(track));
  writer.beginObject("state");
  writer.array("position", rows.positions, 3);
  writer.array("heading", rows.headings);
  writer.array("velocity", rows.velocities, 2);
  writer.array("length", whereSeen(track.size.length));
  writer.array("width", whereSeen(track.size.width));
  writer.array("height", whereSeen(height));
  writer.flags("valid", rows.seen);
  writer.endObject();
  writer.beginObject("metadata");
  writer.text("type", typeOf(track));
  writer.text("class", toString(track.agent_class));
  writer.text("object_id", track.id);
  writer.count("track_length", rows.seen.size());
  writer.endObject();
  writer.endObject();
}

/// Returns the length of a track's path, m.
double distanceOf(const Track& track) {
  double distance = 0.0;
  for (std::size_t i = 1; i < track.states.size(); ++i) {
    const Vector2 before = track.states[i - 1].pose.position();
    distance += (track.states[i].pose.position() - before).norm();
  }
  return distance;
}

/// Returns the number of rows of the track's first stretch without a gap.
std::size_t firstStretch(const Track& track, const std::vector<double>& times) {
  const std::size_t first = rowOf(track.states.front(), times);
  std::size_t count = 1;
  while (count < track.states.size() && rowOf(track.states[count], times) == first + count) {
    ++count;
  }
  return count;
}

using TypeCounts = std::map<std::string, std::size_t>;

void writeCounts(PickleWriter& metadata, const std::string& of_all, const TypeCounts& counts) {
  std::size_t sum = 0;
  metadata.beginObject((of_all + "_each_type").c_str());
  for (const auto& [type, count] : counts) {
    metadata.count(type.c_str(), count);
    sum += count;
  }
  metadata.endObject();
  metadata.count(of_all.c_str(), sum);
}

}  // namespace

void writeTracks(PickleWriter& scenario, const TrackTable& table) {
  scenario.beginObject("tracks");
  for (const Track& track : table.tracks) {
    writeTrack(scenario, track, table.times, heightOf(track));
  }
  scenario.endObject();
}

void writeObjectSummary(PickleWriter& metadata, const TrackTable& table) {
  metadata.beginObject("object_summary");
  for (const Track& track : table.tracks) {
    metadata.beginObject(track.id.c_str());
    metadata.text("type", typeOf(track));
    metadata.text("object_id", track.id);
    metadata.count("track_length", table.times.size());
    metadata.number("moving_distance", distanceOf(track));
    metadata.count("valid_length", track.states.size());
    metadata.count("continuous_valid_length", firstStretch(track, table.times));
    metadata.endObject();
  }
  metadata.endObject();
}

void writeObjectNumbers(PickleWriter& metadata, const TrackTable& table) {
  TypeCounts all;
  TypeCounts moving;
  std::vector<std::string> types;
  for (const Track& track : table.tracks) {
    if (++all[typeOf(track)] == 1) types.emplace_back(typeOf(track));
    if (distanceOf(track) > kLeastDistance) ++moving[typeOf(track)];
  }
  metadata.texts("object_types", types);
  writeCounts(metadata, "num_objects", all);
  writeCounts(metadata, "num_moving_objects", moving);
}

}  // namespace forge
