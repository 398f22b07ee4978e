#pragma once

#include <Eigen/Geometry>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/io/export/road_network.h"

namespace forge {

/// Writes areas of a map as objects of OpenDRIVE, each with its outline on the nearest road within
/// 20 m of the reference line: crosswalks (type `crosswalk`), walkways (type `none`, name
/// `walkway`), and islands (type `trafficIsland`): closed medians and holes of the drivable area up
/// to 300 m^2.
class ObjectWriter {
 public:
  ObjectWriter(const LaneMap& map, const RoadNetwork& network);

  /// Adds the objects of a road, if it has any, to the element of the road.
  void addObjects(pugi::xml_node road_node, const Road& road) const;

 private:
  struct Object {
    const char* type;
    const char* name;
    std::vector<Vector2> outline;  // m, in the map frame; open ring
    int road = 0;                  // id
    double arc_length = 0.0;       // m, of the point nearest to the road, on its reference line
    double lateral = 0.0;          // m from the reference line, positive to the left
  };

  void place(const char* type, const char* name, std::vector<Vector2> outline,
             const RoadNetwork& network);

  std::vector<Eigen::AlignedBox2d> boxes_;  // around the reference line of each road
  std::vector<Object> objects_;
};

}  // namespace forge
