#pragma once

#include <string>
#include <vector>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/io/logs/pickle_field.h"

namespace forge {

/// Messages about parts of map features that cannot be read, each with its position.
struct FeatureProblems {
  std::vector<std::string> left_out;  ///< whole features
  std::vector<std::string> unused;    ///< values of features that are kept
};

/// Returns the name of a kind of feature in scenario descriptions, as "ROAD_EDGE_MEDIAN".
const char* toScenarioNet(FeatureKind kind);

/// Returns the lanes (with mutual links), walkways and features (each FeatureKind) of a scenario
/// description's `map_features`, m, in the frame of the file; without drivable area. Lanes of
/// bicycles are features (kBikeLane), because motor vehicles do not drive there. A lane without an
/// outline gets a strip of kLaneWidth; a lane whose line has no length has no centreline. Features
/// of other types, and lines of fewer than two and areas of fewer than three points, are left out
/// without a message. Leaves out features that cannot be read, and adds a message for each problem
/// to `problems`. Throws std::runtime_error if `features` is not a dict.
LaneMap lanesOf(const PickleField& features, FeatureProblems& problems);

/// Returns polygons with holes, m, from a list of dicts with "exterior" and, optionally,
/// "interiors". Leaves out points that are not finite. Throws std::runtime_error for an element of
/// another form.
std::vector<Polygon> areasOf(const PickleField& areas);

}  // namespace forge
