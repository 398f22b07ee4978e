#pragma once

#include <string>
#include <vector>

#include "collision_forge/io/export/crash_record.h"

namespace forge {

/// A piece of a road's course: a line where the curvature is 0, else an arc.
struct RoadPiece {
  Pose2 start;
  double length = 0.0;     ///< m, > 0
  double curvature = 0.0;  ///< 1/m, positive to the left
};

/// What a road's beginning or end is joined to.
struct RoadJoint {
  enum class To { kNothing, kRoad, kJunction };
  To to = To::kNothing;
  int id = 0;
};

/// One lane or lane connector as a road of its own. The course is the lane's middle, in driving
/// direction.
struct Road {
  int id = 0;                         ///< from 1
  std::string lane;                   ///< id of the lane that it is of
  std::vector<RoadPiece> course;      ///< at least one
  double width = 0.0;                 ///< m
  int junction = 0;                   ///< of a connecting road; 0: a plain one
  RoadJoint before;                   ///< a road is met at its end
  RoadJoint after;                    ///< a road is met at its start
  std::optional<double> speed_limit;  ///< m/s

  double length() const;
};

/// Where roads part and meet. Connecting roads that share an incoming or an outgoing road are of
/// one junction.
struct Junction {
  struct Connection {
    int incoming = 0;    ///< a road
    int connecting = 0;  ///< a road
  };
  int id = 0;  ///< from 1 above the roads' ids
  std::vector<Connection> connections;
};

struct RoadNetwork {
  std::vector<Road> roads;
  std::vector<Junction> junctions;
};

/// The pieces of a lane: its arcs, or where the map has none the arcs through its centreline's
/// poses. Empty for a lane without a course.
std::vector<RoadPiece> courseOf(const Lane& lane, const LaneArcs& arcs);

/// m: the outline's area over the course's length, from 2 to 8; `otherwise` without an outline.
double widthOf(const Lane& lane, double length, double otherwise);

/// Roads as ASAM OpenDRIVE 1.6 joins them (Sec. 8.2 and 10). A lane whose one successor has it as
/// its one predecessor is joined to it. All else goes through junctions: there a connector between
/// two lanes is a connecting road. Between lanes that follow each other at a fork without a
/// connector the first `kForkPiece` of the following lane is one.
/// Links between lanes that do not meet within `kMaxJointGap` are left out, as are lanes without a
/// course.
inline constexpr double kForkPiece = 0.3;    // m
inline constexpr double kMaxJointGap = 0.1;  // m
RoadNetwork roadNetwork(const LaneMap& lanes, const LaneArcs& arcs, double lane_width);

}  // namespace forge
