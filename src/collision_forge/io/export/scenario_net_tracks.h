#pragma once

#include <vector>

#include "collision_forge/base/scene/track.h"
#include "collision_forge/io/export/pickle_writer.h"

namespace forge {

/// The motion of all agents as ScenarioNet stores it: rows on one clock.
struct TrackTable {
  std::vector<double> times;  ///< s, one per row, ascending
  std::vector<Track> tracks;  ///< non-empty; each state's time is in `times`
};

/// Writes "tracks", with zeros in rows without a state.
void writeTracks(PickleWriter& scenario, const TrackTable& table);

/// Writes the metadata's "object_summary".
void writeObjectSummary(PickleWriter& metadata, const TrackTable& table);

/// Writes the fields on tracks of the metadata's "number_summary".
void writeObjectNumbers(PickleWriter& metadata, const TrackTable& table);

}  // namespace forge
