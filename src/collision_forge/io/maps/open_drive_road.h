#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/base/scene/input_limits.h"
#include "collision_forge/io/maps/open_drive_line.h"

namespace forge {

/// m; longer lane sections are cut, so that no lane of the map is longer.
inline constexpr double kLongestSection = 500.0;

/// Driving direction of a lane. OpenDRIVE 1.8: attribute `direction`.
enum class LaneDirection {
  kStandard,  ///< by the driving side and the side of the reference line
  kReversed,  ///< against kStandard
  kBoth,      ///< either direction
};

/// A lane of a lane section.
struct OpenDriveLane {
  int id = 0;        ///< > 0: left of the reference line; < 0: right; counted outwards; never 0
  std::string type;  ///< as in the file; see laneUse()
  LaneDirection direction = LaneDirection::kStandard;
  /// Over the arc length of the road, m: the width of the lane, or its outer border's distance from
  /// the lane offset, positive to the left. Empty if the file has neither: width 0.
  PiecewiseCubic outline;
  bool is_border = false;             ///< true: `outline` is the border; false: the width
  std::vector<int> predecessors;      ///< ids in the previous section, or at the start of the road
  std::vector<int> successors;        ///< ids in the next section, or at the end of the road
  std::optional<double> speed_limit;  ///< m/s, of the lane or else of its road; empty: none
};

/// Lanes between two arc lengths of a road.
struct OpenDriveSection {
  double begin = 0.0;                ///< m, arc length on OpenDriveRoad::line
  double end = 0.0;                  ///< m, arc length, >= begin
  std::vector<OpenDriveLane> left;   ///< from the reference line outwards
  std::vector<OpenDriveLane> right;  ///< from the reference line outwards
  /// True: the next section is the rest of this one (kLongestSection): its lanes have the same ids.
  bool continues = false;
};

/// The element that follows a road at its start or end.
struct OpenDriveLink {
  /// Kind of the other element; kNothing: there is none.
  enum class To { kNothing, kRoad, kJunction };
  To to = To::kNothing;
  std::string id;       ///< id of the road or junction; "" for kNothing
  bool at_end = false;  ///< for a road: true if it is joined at its end, false at its start
};

/// A road of an OpenDRIVE file.
struct OpenDriveRoad {
  std::string id;        ///< id in the file
  std::string junction;  ///< id of the junction; "" for a road that is not inside a junction
  DrivingSide side = DrivingSide::kRight;  ///< attribute `rule`; right if it is missing
  ReferenceLine line;                      ///< frame of the map; at least one piece
  PiecewiseCubic lane_offset;  ///< m from `line` to the border between left and right lanes,
                               ///< positive to the left
  /// Ascending, without gaps to the end of `line`; at least one.
  std::vector<OpenDriveSection> sections;
  OpenDriveLink before;  ///< the element at the start of the road
  OpenDriveLink after;   ///< the element at its end
};

/// Reads one element <road>, of OpenDRIVE 1.4 to 1.8, into the map frame. `origin`: pose of the
/// file's coordinates in the map (element <offset>); `path` is for messages. Sections longer than
/// kLongestSection are cut.
///
/// Throws MapError, naming element, attribute and value, for a road without geometry or lanes, an
/// unknown geometry, a missing number, and a line beyond the limits. Unusable links and speed
/// limits are left out.
OpenDriveRoad readOpenDriveRoad(const pugi::xml_node& road, const Pose2& origin,
                                const InputLimits& limits, const std::string& path);

}  // namespace forge
