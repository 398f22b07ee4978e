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

/// A lanelet of a CommonRoad file. Points in m, in the file's frame, which is the map frame.
struct CommonRoadLanelet {
  std::string id;
  LaneBounds bounds;                      ///< in driving direction
  std::vector<std::string> predecessors;  ///< ids of lanelets; may be missing in the file
  std::vector<std::string> successors;    ///< ids of lanelets; may be missing in the file
  /// True: the adjacent lanelet to the left has the opposite direction.
  bool oncoming_left = false;
  bool oncoming_right = false;            ///< the same for the adjacent lanelet to the right
  std::set<std::string> types;            ///< laneletType
  std::set<std::string> users_one_way;    ///< userOneWay: users in driving direction
  std::set<std::string> users_both_ways;  ///< userBidirectional: users in both directions
  std::optional<double> speed_limit;      ///< m/s, own or of its traffic sign; empty: unknown
  bool is_in_intersection = false;        ///< by its type or an <intersection>
};

/// A static or dynamic obstacle. Times in s from step 0; positions count as box centres.
struct CommonRoadObstacle {
  /// Id and class of the obstacle; velocities along the heading, derived from the positions where
  /// the file has none.
  Track track;
  /// True: the first state of `track` holds at all times; false: two or more states.
  bool is_static = false;
};

/// Key of the driving side in the attribute `source` of files of this package; "left" or "right"
/// follows.
inline constexpr char kDrivingSideKey[] = "driving_side=";

/// The content of a CommonRoad file, version 2018b or 2020a (TU Munich). Metres, radians, the
/// file's frame.
struct CommonRoadFile {
  std::string benchmark;  ///< benchmarkID
  double step = 0.0;      ///< s between steps
  /// As in a file of this package (kDrivingSideKey); empty in other files.
  std::optional<DrivingSide> driving_side;
  std::vector<CommonRoadLanelet> lanelets;
  std::vector<CommonRoadObstacle> obstacles;
  /// Initial states of the planning problems, s from step 0; velocity NaN if the file has none.
  std::vector<AgentState> problem_starts;
};

/// Reads a CommonRoad file. A value given as an interval counts as its middle, a region as its
/// centre. Leaves out elements that cannot be used: lanelets without two bounds, states without
/// position, heading or time, and obstacles without such a state or with occupancy sets only.
/// Shapes become boxes around them.
///
/// Throws MapError for malformed XML and for a missing or wrong timeStepSize. Lists in the result
/// are in the file's order. Adds the elements that are left out to `warnings`. Only
/// `options.input_limits` is used: values beyond the limits cannot be used.
CommonRoadFile readCommonRoadFile(const std::string& path, const DataOptions& options,
                                  WarningCounter& warnings);

}  // namespace forge
