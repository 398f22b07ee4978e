#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "collision_forge/planner_test/sweeps/sweep_cells.h"

namespace forge {

/// An axis of a map of a sweep. A place on the axis is an index into `labels` in a grid, else a
/// value as in SweepAxis::values. If a sweep varies one parameter, the vertical axis is missing:
/// its only place is 0.
struct MapAxis {
  std::string heading;  ///< SweepParameter::heading, with the unit; "" for a missing axis
  /// The values are indices into SweepParameter::words; true for a missing axis.
  bool has_words = false;
  std::vector<double> values;  ///< distinct values of all cells, ascending; {0} for a missing axis
  std::vector<std::string> labels;  ///< SweepParameter::text() of each of `values`
  double min = 0.0;                 ///< least of `values`; 0 for a missing axis
  double max = 1.0;                 ///< greatest of `values`; 0 for a missing axis
};

/// A cell of a map: one cell of the sweep, or all cells with the same values on both axes, which
/// differ in the parameters off the map.
struct MapTile {
  double x = 0.0;                                  ///< place on the horizontal axis (MapAxis)
  double y = 0.0;                                  ///< place on the vertical axis
  SweepVerdict verdict = SweepVerdict::kRejected;  ///< of all feasible cells; kMixed if they
                                                   ///< differ, kRejected if there is none
  std::string text;  ///< of one cell: the planner's impact speed in m/s ("7.4") if it is hit, else
                     ///< ""; of several: "HITS/FEASIBLE" cells, "" if none is feasible
  std::size_t cell = 0;   ///< index of the first of these cells in the `cells` of sweepMap()
  std::size_t count = 0;  ///< number of these cells, rejected ones included
};

/// A change of the verdict between two neighbours of a row of the grid. A row is all cells that
/// differ only in the horizontal parameter of the map; a neighbour has the next value of this
/// parameter.
struct MapBoundary {
  std::vector<double> values;  ///< of the row, in the order of SweepCell::values; the horizontal
                               ///< parameter has the midpoint between the two neighbours
  SweepVerdict below = SweepVerdict::kHit;  ///< of the neighbour with the smaller value
  SweepVerdict above = SweepVerdict::kHit;  ///< of the neighbour with the greater value
};

/// The verdicts for one planner or careful driver.
struct MapPanel {
  std::string name;            ///< SweepOutcome::name; "" if no cell is feasible
  bool is_driver = false;      ///< true: a careful driver; false: a planner
  std::vector<MapTile> tiles;  ///< one per pair of places with a cell, sorted by x, then by y
  /// Sorted by row (the other values), then by the horizontal value. Empty for a Latin hypercube
  /// and if the horizontal parameter has words. There is no boundary beside a rejected cell.
  std::vector<MapBoundary> boundaries;
};

/// Pass and fail over two parameters of a sweep, one panel per planner and careful driver.
struct SweepMap {
  bool is_grid = true;           ///< as SweepLayout::is_grid
  MapAxis x;                     ///< horizontal
  MapAxis y;                     ///< vertical
  std::vector<MapPanel> panels;  ///< in the order of first appearance in outcomesOf() of the cells;
                                 ///< a single one without a name if no cell is feasible
};

/// Returns the map of all cells over layout.x and layout.y. `cells` must not be empty.
SweepMap sweepMap(const SweepLayout& layout, const std::vector<SweepCell>& cells);

/// Returns the content of boundary.csv: a header, then a row per boundary, panel by panel. Columns:
/// "name" (of the panel), SweepParameter::name of each parameter of the layout (values as
/// SweepParameter::text(), words as words), "verdict_below" and "verdict_above" (toString()).
/// Without boundaries, only the header.
std::string boundaryCsv(const SweepLayout& layout, const SweepMap& map);

}  // namespace forge
