#pragma once

#include <vector>

#include "collision_forge/base/map/lane_map.h"

namespace forge {

/// A lane and the data of its lanelet.
struct Lanelet {
  int number = 0;  ///< id in the file
  const Lane* lane = nullptr;
  std::vector<Pose2> middle;  ///< two or more distinct poses
  double width = 0.0;         ///< m
  int left = 0;               ///< number of the adjacent lanelet; 0: none
  int right = 0;
  bool is_for_bikes = false;
};

/// Returns the lanes of `map` that have two or more distinct centreline poses as lanelets, numbered
/// from `first`, with their neighbours of the same direction; then `bike_lanes`, which have none.
/// `lane_width` (m) is the width of lanes without an outline. The lanelets refer to the lanes,
/// which must outlive them.
std::vector<Lanelet> laneletsOf(const LaneMap& map, const std::vector<Lane>& bike_lanes,
                                double lane_width, int first);

/// Returns the left (`side` +1) or right (-1) bound, with as many points as `lanelet.middle`. The
/// middle of both bounds is the centreline; in a tight bend the lanelet is narrower, so that the
/// inner bound never runs backwards.
std::vector<Vector2> boundOf(const Lanelet& lanelet, double side);

}  // namespace forge
