#pragma once

#include <vector>

#include "collision_forge/base/scene/track.h"
#include "collision_forge/io/export/pickle_writer.h"

namespace forge {

/// The motion of all agents as ScenarioNet stores it: rows on one clock. Poses are box centres, map
/// frame.
struct TrackTable {
  std::vector<double> times;  ///< s, one per row, ascending, 0 at the first row
  /// Each has states, sorted by time; each state's time is an element of `times`.
  std::vector<Track> tracks;
};

/// Writes "tracks" into a scenario, with zeros, and `valid` false, in rows without a state. Box
/// heights are heightOf().
void writeTracks(PickleWriter& scenario, const TrackTable& table);

/// Writes the metadata's "object_summary", for each track: type, object_id, track_length (number of
/// rows of the table), moving_distance (length of the path, m), valid_length (number of states) and
/// continuous_valid_length (number of states from the first one up to the first gap).
void writeObjectSummary(PickleWriter& metadata, const TrackTable& table);

/// Writes the fields on tracks of the metadata's "number_summary": numbers of agents, and of moving
/// agents (path longer than 1 m), each by type (num_objects_each_type,
/// num_moving_objects_each_type) and in all (num_objects, num_moving_objects), and object_types, in
/// the order of the tracks.
void writeObjectNumbers(PickleWriter& metadata, const TrackTable& table);

}  // namespace forge
