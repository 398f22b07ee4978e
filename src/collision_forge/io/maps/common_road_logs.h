#pragma once

#include <string>
#include <vector>

#include "collision_forge/io/logs/log_source.h"

namespace forge {

/// Returns the format of CommonRoad scenarios (2018b, 2020a): an .xml file or a folder of them,
/// each a scene named after its file. The object lives until the program ends.
const LogFormat& commonRoadFormat();

/// Reads the scenario in the file `path`. Its positions are in the map frame.
/// - Ego: the dynamic obstacle with the id `ego`. If `ego` is empty: the car, truck or bus that is
///   at the start of a planning problem (to 1 m, at its step; the first such problem counts); else
///   the one with states for the longest time, with a warning; among equals the one whose first
///   state is nearest to a start.
/// - Frames: the steps with a state of the ego. Step 0 is at 1 s, because a bag cannot hold time 0.
/// - Agents: the other obstacles, interpolated at the frames; static ones are in all frames.
///
/// Throws as readCommonRoadFile(), MapError for a scenario without an ego or without a dynamic
/// obstacle of the id `ego`, and InputError for values beyond the limits of `options`. Appends one
/// line per kind of problem to `warnings`, if not null.
LoggedScene readCommonRoadScenario(const std::string& path, const std::string& ego,
                                   const DataOptions& options,
                                   std::vector<std::string>* warnings = nullptr);

}  // namespace forge
