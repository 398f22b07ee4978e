#pragma once

#include <map>
#include <vector>

#include "collision_forge/base/scene/track.h"
#include "collision_forge/io/export/pickle_writer.h"

namespace forge {

/// How everybody moves, as ScenarioNet tells it: in rows on one clock.
struct TrackTable {
  std::vector<double> times;  ///< s, a row each, ascending
  std::vector<Track> tracks;  ///< none without a state; each state's time is one of `times`
};

/// Writes the scenario's "tracks", with zeros where one is not seen. `heights`: m, of boxes.
void writeTracks(PickleWriter& scenario, const TrackTable& table,
                 const std::map<AgentClass, double>& heights);

/// Writes the metadata's "object_summary".
void writeObjectSummary(PickleWriter& metadata, const TrackTable& table);

/// Writes what the metadata's "number_summary" says of tracks.
void writeObjectNumbers(PickleWriter& metadata, const TrackTable& table);

}  // namespace forge
