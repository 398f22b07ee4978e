#pragma once

#include <string>
#include <vector>

#include "collision_forge/io/export/crash_record.h"

namespace forge {

/// A piece of a road's reference line: a line if the curvature is 0, else an arc.
struct RoadPiece {
  Pose2 start;
  double length = 0.0;     ///< m, > 0
  double curvature = 0.0;  ///< 1/m, positive to the left
};

/// The element to which the start or end of a road is linked.
struct RoadJoint {
  enum class To { kNothing, kRoad, kJunction };
  To to = To::kNothing;
  int id = 0;  ///< of the road or junction
};

/// A lane or lane connector as a road of its own. The reference line is the lane's centreline, in
/// driving direction.
struct Road {
  int id = 0;                         ///< from 1
  std::string lane;                   ///< id of the map's lane
  std::vector<RoadPiece> course;      ///< at least one
  double width = 0.0;                 ///< m
  int junction = 0;                   ///< id, for connecting roads; 0: not in a junction
  RoadJoint before;                   ///< predecessor; a road is joined at its end
  RoadJoint after;                    ///< successor; a road is joined at its start
  std::optional<double> speed_limit;  ///< m/s

  /// Returns the length of the reference line, m.
  double length() const;
};

/// A fork or merge of roads. Connecting roads that share an incoming or an outgoing road belong to
/// the same junction.
struct Junction {
  struct Connection {
    int incoming = 0;    ///< id of a road
    int connecting = 0;  ///< id of a road
  };
  int id = 0;  ///< above all road ids
  std::vector<Connection> connections;
};

/// Roads and junctions of one OpenDRIVE file.
struct RoadNetwork {
  std::vector<Road> roads;
  std::vector<Junction> junctions;
};

/// Returns the reference line of a lane: its arcs, or arcs through the centreline's poses if the
/// map has none. Empty for a lane shorter than 5 cm.
std::vector<RoadPiece> courseOf(const Lane& lane, const LaneArcs& arcs);

/// Returns the lane width in m: the outline's area over `length`, clamped to 2 to 8 m; `otherwise`
/// if there is no outline.
double widthOf(const Lane& lane, double length, double otherwise);

inline constexpr double kForkPiece = 0.3;    ///< m; length of a connecting road at a fork
inline constexpr double kMaxJointGap = 0.1;  ///< m; lanes farther apart are not linked
/// Returns the lanes as roads linked by the rules of ASAM OpenDRIVE 1.6 (Sec. 8.2 and 10). A lane
/// whose only successor has no other predecessor is linked to it directly. All other links go
/// through junctions: a connector between two lanes becomes the connecting road; at a fork without
/// a connector, the first kForkPiece of the following lane becomes the connecting road. Links
/// between lanes more than kMaxJointGap apart and lanes without a reference line are left out.
/// `lane_width` (m) is the width of lanes without an outline.
RoadNetwork roadNetwork(const LaneMap& lanes, const LaneArcs& arcs, double lane_width);

}  // namespace forge
