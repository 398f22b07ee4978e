#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_forge/base/geometry/polygon.h"
#include "collision_forge/base/geometry/pose2.h"

namespace forge {

enum class DrivingSide { kRight, kLeft };

/// m; of a lane without an outline: the usual width of a road of two lanes and more in towns.
inline constexpr double kLaneWidth = 3.5;

/// A lane, or a lane connector (the path through a junction). Global map frame.
struct Lane {
  std::string id;
  bool is_connector = false;
  bool is_intersection = false;       ///< lies in a road segment marked as an intersection
  std::vector<Pose2> centerline;      ///< in driving direction; empty when the map has none
  std::vector<Vector2> polygon;       ///< outline, open ring; may be empty
  std::vector<std::string> incoming;  ///< ids of lanes that lead here; all exist in the map
  std::vector<std::string> outgoing;  ///< ids of lanes that follow; all exist in the map
  std::optional<double> speed_limit;  ///< m/s; empty where the map has none, as nuScenes' maps
};

/// The lanes, the drivable ground and the walkways of one place. Global map frame, metres.
struct LaneMap {
  std::string location;
  DrivingSide driving_side = DrivingSide::kRight;
  std::vector<Lane> lanes;
  std::vector<Polygon> drivable_area;  ///< polygons may overlap: the area is their union
  std::vector<Polygon> walkways;       ///< raised ground behind kerbs; empty where unknown
};

}  // namespace forge
