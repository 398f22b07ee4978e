#pragma once

#include <vector>

#include "collision_forge/base/geometry/polygon.h"

namespace forge {

/// Values at the nodes of a grid with square cells, aligned to the axes of the map frame.
struct ValueGrid {
  Vector2 origin = Vector2::Zero();  ///< m, global map frame: node (0, 0), at the smallest x and y
  double spacing = 0.0;              ///< m between nodes
  int columns = 0;                   ///< nodes along x, at least 2
  int rows = 0;                      ///< nodes along y, at least 2
  std::vector<float> values;  ///< node (column, row) at index row * columns + column; none is 0
};

/// Returns the area where the grid's values are positive, by marching squares: its border crosses
/// the grid lines where linear interpolation between two nodes is 0. Nodes on the grid's border
/// count as negative. Exteriors are counter-clockwise, holes clockwise. Rings are simplified to 2
/// cm; rings, also of holes, with an area below `min_area` (m2) are left out. Empty if no value is
/// positive.
std::vector<Polygon> positiveArea(const ValueGrid& grid, double min_area);

}  // namespace forge
