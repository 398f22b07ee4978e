#pragma once

#include <optional>
#include <pugixml.hpp>

#include "collision_forge/io/export/lane_marks.h"
#include "collision_forge/io/export/road_network.h"
#include "collision_forge/io/export/road_sidewalks.h"

namespace forge {

/// Returns the speed limit (m/s) that all lanes of a road have; empty if they have none or differ.
std::optional<double> commonLimit(const Road& road);

/// Adds the element `speed` with a limit in m/s. `place` (m) is the attribute `sOffset`; empty:
/// none.
void addSpeedLimit(pugi::xml_node parent, double limit, std::optional<double> place = {});

/// Writes the lanes of OpenDRIVE roads.
///
/// Lanes for motor vehicles have type `driving`, lanes for bicycles `biking`, gaps `none`. A
/// walkway along a road (SidewalkFinder) becomes a lane `sidewalk` outside of the others, and the
/// gap before it a lane `shoulder` if it is drivable. Marks follow the painted lines of the map
/// (PaintedLines); where the map has none, marks are assumed: broken between lanes of one
/// direction, else solid. Roads in junctions have no marks.
class LaneWriter {
 public:
  /// Keeps references to `map`, which must outlive the object.
  explicit LaneWriter(const LaneMap& map);

  /// Adds `laneOffset` and lane sections of a road to its element `lanes`.
  void addLanes(pugi::xml_node lanes, const Road& road) const;

 private:
  struct Section;

  void addSide(pugi::xml_node section_node, const Road& road, int side, const Sidewalk& sidewalk,
               const Section& section) const;
  void addLane(pugi::xml_node side, const Road& road, const RoadLane& lane,
               const Section& section) const;
  void addMarks(pugi::xml_node lane, const Road& road, int id, bool is_broken,
                const Section& section) const;

  const PaintedLines lines_;
  const SidewalkFinder sidewalks_;
};

}  // namespace forge
