#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "collision_forge/base/scene/track.h"
#include "collision_forge/io/logs/nuscenes_map_layers.h"
#include "collision_forge/io/logs/options.h"
#include "collision_forge/io/maps/lane_shapes.h"

namespace forge {

/// A lanelet of a CommonRoad file.
struct CommonRoadLanelet {
  std::string id;
  LaneBounds bounds;
  std::vector<std::string> predecessors;
  std::vector<std::string> successors;
  bool oncoming_left = false;   ///< the adjacent lanelet to the left has the opposite direction
  bool oncoming_right = false;  ///< the same for the adjacent lanelet to the right
  std::set<std::string> types;  ///< laneletType
  std::set<std::string> users_one_way;    ///< userOneWay
  std::set<std::string> users_both_ways;  ///< userBidirectional
  std::optional<double> speed_limit;      ///< m/s
  bool is_in_intersection = false;        ///< by its type or an <intersection>
};

/// A static or dynamic obstacle. Times in s from step 0.
struct CommonRoadObstacle {
  Track track;             ///< id and class of the obstacle; velocities along the heading
  bool is_static = false;  ///< `track` has one state, which holds at all times
};

/// Key of the driving side in the attribute `source` of files of this package; "left" or "right"
/// follows.
inline constexpr char kDrivingSideKey[] = "driving_side=";

/// The content of a CommonRoad file, version 2018b or 2020a (TU Munich). Metres, radians.
struct CommonRoadFile {
  std::string benchmark;                    ///< benchmarkID
  double step = 0.0;                        ///< s between steps
  std::optional<DrivingSide> driving_side;  ///< of a file of this package
  std::vector<CommonRoadLanelet> lanelets;
  std::vector<CommonRoadObstacle> obstacles;
  std::vector<AgentState> problem_starts;  ///< initial states of the planning problems
};

/// Reads a CommonRoad file. A value given as an interval counts as its middle, a region as its
/// centre. Leaves out elements that cannot be used: lanelets without two bounds, states without
/// position, heading or time, and obstacles without such a state or with occupancy sets only.
/// Shapes become boxes around them.
///
/// Throws MapError for malformed XML and for a missing or wrong timeStepSize.
CommonRoadFile readCommonRoadFile(const std::string& path, const DataOptions& options,
                                  WarningCounter& warnings);

}  // namespace forge
