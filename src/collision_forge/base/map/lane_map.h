#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_forge/base/geometry/polygon.h"
#include "collision_forge/base/geometry/pose2.h"

namespace forge {

/// Side of the road on which traffic drives.
enum class DrivingSide { kRight, kLeft };

/// m; width assumed for a lane without an outline: usual for town roads of two or more lanes.
inline constexpr double kLaneWidth = 3.5;

/// A lane, or a lane connector (the path through a junction). Global map frame, m.
struct Lane {
  std::string id;                 ///< unique in the map
  bool is_connector = false;      ///< true: the path through a junction
  bool is_intersection = false;   ///< within a road segment marked as an intersection; a connector
                                  ///< need not be
  std::vector<Pose2> centerline;  ///< in driving direction, yaw along it; empty when the map has
                                  ///< none
  std::vector<Vector2> polygon;   ///< outline, open ring; empty if unknown
  std::vector<std::string> incoming;  ///< ids of predecessor lanes, all in the map
  std::vector<std::string> outgoing;  ///< ids of successor lanes, all in the map
  std::optional<double> speed_limit;  ///< m/s; empty if unknown, as in nuScenes
};

/// Kind of a MapFeature.
enum class FeatureKind {
  kRoadEdge,          ///< boundary of the road: kerb, wall or border of the pavement
  kMedian,            ///< road edge between opposite directions
  kCrosswalk,         ///< painted crossing for pedestrians
  kDriveway,          ///< private entrance that crosses the walkway
  kSpeedBump,         ///< raised strip across the road
  kBrokenWhiteLine,   ///< painted line that may be crossed, on one side at least
  kBrokenYellowLine,  ///< the same in yellow
  kSolidWhiteLine,    ///< painted line that must not be crossed
  kSolidYellowLine,   ///< the same in yellow
  kBikeLane,          ///< centreline of a lane for bicycles, in driving direction
};

/// Returns true for kRoadEdge and kMedian.
inline bool isRoadEdge(FeatureKind kind) {
  return kind == FeatureKind::kRoadEdge || kind == FeatureKind::kMedian;
}

/// Returns true for painted lines.
inline bool isPaintedLine(FeatureKind kind) {
  return kind >= FeatureKind::kBrokenWhiteLine && kind <= FeatureKind::kSolidYellowLine;
}

/// Returns true for painted lines that may be crossed, on one side at least.
inline bool isBrokenLine(FeatureKind kind) {
  return kind == FeatureKind::kBrokenWhiteLine || kind == FeatureKind::kBrokenYellowLine;
}

inline bool isYellowLine(FeatureKind kind) {
  return kind == FeatureKind::kBrokenYellowLine || kind == FeatureKind::kSolidYellowLine;
}

/// Returns true for features whose points are an open line; the points of others are an outline.
inline bool isOpenLine(FeatureKind kind) {
  return isRoadEdge(kind) || isPaintedLine(kind) || kind == FeatureKind::kBikeLane;
}

/// A recorded feature of the road besides lanes and areas. Global map frame.
struct MapFeature {
  FeatureKind kind = FeatureKind::kRoadEdge;
  std::vector<Vector2> points;  ///< m; an open line (isOpenLine()), or an outline: an open ring
};

/// The lanes, the drivable area and the walkways of one location. Global map frame, metres.
struct LaneMap {
  std::string location;  ///< name of the place, as "boston-seaport"
  DrivingSide driving_side = DrivingSide::kRight;
  std::vector<Lane> lanes;  ///< lanes and lane connectors
  /// Union of the polygons, which may overlap; empty if unknown.
  std::vector<Polygon> drivable_area;
  std::vector<Polygon> walkways;     ///< raised ground behind kerbs; empty if unknown
  std::vector<MapFeature> features;  ///< as recorded; empty if unknown
};

}  // namespace forge
