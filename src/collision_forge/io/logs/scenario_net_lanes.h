#pragma once

#include <string>
#include <vector>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/io/logs/pickle_field.h"

namespace forge {

/// Messages about parts of map features that cannot be read.
struct FeatureProblems {
  std::vector<std::string> left_out;  ///< whole features
  std::vector<std::string> unused;    ///< values of features that are kept
};

/// Returns the name of a kind of feature in scenario descriptions, as "ROAD_EDGE_MEDIAN".
const char* toScenarioNet(FeatureKind kind);

/// Returns the lanes (with mutual links), walkways and features of a scenario description's
/// `map_features`, m, in the frame of the file; without drivable area. Lanes of bicycles are
/// features, because motor vehicles do not drive there. Leaves out features that cannot be read.
/// Throws std::runtime_error if `features` is not a dict.
LaneMap lanesOf(const PickleField& features, FeatureProblems& problems);

/// Returns polygons with holes from a list of dicts with "exterior" and "interiors". Throws
/// std::runtime_error for an element of another form.
std::vector<Polygon> areasOf(const PickleField& areas);

}  // namespace forge
