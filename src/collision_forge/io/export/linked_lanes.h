#pragma once

#include <cstddef>
#include <vector>

#include "collision_forge/io/export/lane_bundles.h"

namespace forge {

/// The lanes of a map that have a course, and the links between them; lanes are identified by their
/// index. Lanes for bicycles follow the others.
struct LinkedLanes {
  std::vector<BundleLane> lanes;
  std::vector<const Lane*> sources;                ///< per lane; of the map, or of `bike_lanes`
  std::vector<std::vector<std::size_t>> next;      ///< per lane
  std::vector<std::vector<std::size_t>> previous;  ///< per lane
  std::vector<Lane> bike_lanes;                    ///< of bikeLanesOf(), those with a course

  /// Returns true if a lane is for bicycles.
  bool isForBikes(std::size_t lane) const { return lane >= lanes.size() - bike_lanes.size(); }
};

inline constexpr double kBikeLaneWidth = 1.5;  ///< m, of lanes for bicycles: usual width in towns

/// Returns a lane per kBikeLane of a map, with a centreline and without links; its id is "bike_"
/// and a number from 1.
std::vector<Lane> bikeLanesOf(const LaneMap& map);

inline constexpr double kMaxJointGap = 0.1;  ///< m; lanes farther apart are not linked
/// Returns the lanes of a map, which must outlive them. Leaves out links between lanes more than
/// kMaxJointGap apart. `arcs` and `lane_width` (m) as for roadNetwork(). Do not copy the result:
/// `sources` may refer to its `bike_lanes`; moving it is allowed.
LinkedLanes linkedLanes(const LaneMap& map, const LaneArcs& arcs, double lane_width);

}  // namespace forge
