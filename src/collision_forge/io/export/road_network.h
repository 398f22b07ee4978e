#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/io/export/road_course.h"

namespace forge {

/// The element to which the start or end of a road is linked.
struct RoadJoint {
  enum class To { kNothing, kRoad, kJunction };
  To to = To::kNothing;
  int id = 0;           ///< of the road or junction
  bool at_end = false;  ///< the other road is joined at its end, else at its start
};

/// A lane of a road.
struct RoadLane {
  int id = 0;                 ///< OpenDRIVE's: > 0 left of the centre, < 0 right of it; never 0
  std::string lane;           ///< id of the map's lane; "" for the gap between the directions or
                              ///< between lanes
  bool is_for_bikes = false;  ///< a FeatureKind::kBikeLane, else a lane for motor vehicles
  double from = 0.0;          ///< m, arc length of the road at which the lane begins
  double to = 0.0;            ///< m, at which it ends; only gaps elsewhere
  std::vector<double> width;  ///< m, per Road::knots
  std::optional<int> before;  ///< id of the lane linked at the start of the road
  std::optional<int> after;   ///< id of the lane linked at its end
  std::optional<double> speed_limit;  ///< m/s
};

/// Lanes side by side. The reference line is the course of one of the lanes that are driven along
/// it; the others are driven against it.
struct Road {
  int id = 0;                  ///< from 1
  RoadCourse course;           ///< not empty
  std::vector<double> knots;   ///< m, arc lengths, ascending from 0; widths and offset are linear
                               ///< in between and constant after the last
  std::vector<double> offset;  ///< m, per knot: from the course to the centre (lane 0), positive to
                               ///< the left
  std::vector<RoadLane> left;  ///< from the centre outwards
  std::vector<RoadLane> right;
  int junction = 0;  ///< id, for connecting roads; 0: not in a junction
  RoadJoint before;
  RoadJoint after;

  /// Returns the ids of the map's lanes, joined by spaces.
  std::string name() const;

  /// Returns the value (of widths or offset) at an arc length, m.
  double valueAt(const std::vector<double>& per_knot, double arc_length) const;

  /// Returns the distance (m, positive to the left) from the course to the outer border of the lane
  /// with this id (OpenDRIVE's; 0: the centre) at an arc length, m.
  double borderAt(int id, double arc_length) const;
};

/// A fork or merge of roads. Connecting roads that share an incoming or an outgoing road end belong
/// to the same junction.
struct Junction {
  struct Connection {
    int incoming = 0;    ///< id of a road
    int connecting = 0;  ///< id of a road, joined at its start
    int from = 0;        ///< id of the lane of the incoming road
    int to = 0;          ///< id of the lane of the connecting road
  };
  int id = 0;  ///< above all road ids
  std::vector<Connection> connections;
};

/// Roads and junctions of one OpenDRIVE file.
struct RoadNetwork {
  std::vector<Road> roads;
  std::vector<Junction> junctions;
  std::size_t unbundled = 0;  ///< LaneBundles::unbundled
};

inline constexpr double kForkPiece = 0.3;  ///< m; length of a connecting road at a fork
/// Returns the lanes as roads linked by the rules of ASAM OpenDRIVE 1.6 (Sec. 8.2 and 10). Lanes
/// side by side share a road (bundlesOf()). Two road ends whose lanes lead one to one into each
/// other are linked directly. All other links go through junctions: a connector between two lanes
/// becomes a connecting road; without a connector, the first kForkPiece of the following lane
/// becomes one. The part of a lane beyond the end of its road belongs to the connecting road. Links
/// between lanes more than kMaxJointGap (linked_lanes.h) apart and lanes without a course are left
/// out. Each kBikeLane of the map is a road of its own, without links, whose lane id is "bike_" and
/// a number. `lane_width` (m) is the width of lanes without an outline.
RoadNetwork roadNetwork(const LaneMap& lanes, const LaneArcs& arcs, double lane_width);

}  // namespace forge
