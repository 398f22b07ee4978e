#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/io/export/road_course.h"

namespace forge {

/// The element to which the start or end of a road is linked.
struct RoadJoint {
  /// Kind of the other element; kNothing: there is none.
  enum class To { kNothing, kRoad, kJunction };
  To to = To::kNothing;
  int id = 0;           ///< id of the road or junction; unused for kNothing
  bool at_end = false;  ///< for a road: true if it is joined at its end, false at its start
};

/// A lane of a road.
struct RoadLane {
  /// OpenDRIVE's: > 0 left of the centre, < 0 right of it, counted outwards from 1 or -1; never 0.
  int id = 0;
  /// Id of the map's lane, or of the one of bikeLanesOf(); "" for the gap between the directions or
  /// between lanes.
  std::string lane;
  bool is_for_bikes = false;  ///< a FeatureKind::kBikeLane, else a lane for motor vehicles or a gap
  double from = 0.0;          ///< m, arc length of the road at which the lane begins
  /// m, arc length at which the lane ends; outside `from` to `to`, its strip of the road is a gap.
  double to = 0.0;
  std::vector<double> width;  ///< m, one per element of Road::knots
  /// Id of the lane linked at the start of the road, in the road there; empty: none or through a
  /// junction.
  std::optional<int> before;
  std::optional<int> after;           ///< id of the lane linked at the end of the road; likewise
  std::optional<double> speed_limit;  ///< m/s; empty: unknown
};

/// Lanes side by side. The reference line is the course of one of the lanes that are driven along
/// it; the other lanes are driven along or against it, by the side of the road. Start and end are
/// as on the reference line.
struct Road {
  int id = 0;                  ///< from 1
  RoadCourse course;           ///< reference line, map frame; not empty
  std::vector<double> knots;   ///< m, arc lengths, ascending from 0; widths and offset are linear
                               ///< in between and constant after the last
  std::vector<double> offset;  ///< m, per knot: from the course to the centre (lane 0), positive to
                               ///< the left
  std::vector<RoadLane> left;  ///< from the centre outwards, left of the reference direction
  std::vector<RoadLane> right;  ///< from the centre outwards, right of it
  int junction = 0;             ///< id, for connecting roads; 0: not in a junction
  RoadJoint before;             ///< element at the start of the road
  RoadJoint after;              ///< element at the end of the road

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
  /// One lane that enters a connecting road.
  struct Connection {
    int incoming = 0;    ///< id of the road that leads in
    int connecting = 0;  ///< id of the connecting road, entered at its start
    int from = 0;        ///< id of the lane of the incoming road
    int to = 0;          ///< id of the lane of the connecting road
  };
  int id = 0;  ///< above all road ids
  std::vector<Connection> connections;
};

/// Roads and junctions of one OpenDRIVE file.
struct RoadNetwork {
  std::vector<Road> roads;          ///< sorted by id, without gaps from 1
  std::vector<Junction> junctions;  ///< sorted by id
  std::size_t unbundled = 0;        ///< LaneBundles::unbundled
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
