#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "collision_forge/planner_test/sweeps/sweep_cells.h"

namespace forge {

/// An axis of a map of a sweep. In a grid a place is an index into `labels`; else a place is a
/// value, as in SweepAxis, in [min, max].
struct MapAxis {
  std::string heading;              ///< SweepParameter::heading; "" for a missing axis
  bool has_words = false;           ///< the values are words
  std::vector<double> values;       ///< of the sweep, ascending
  std::vector<std::string> labels;  ///< of the values
  double min = 0.0;
  double max = 1.0;
};

/// A cell of a map, or several cells of the sweep that differ in the parameters off the map.
struct MapTile {
  double x = 0.0;  ///< place on the axes
  double y = 0.0;
  SweepVerdict verdict = SweepVerdict::kRejected;
  std::string text;       ///< impact speed of a hit in m/s, or hits of feasible cells; may be empty
  std::size_t cell = 0;   ///< index of the (first) cell of the sweep
  std::size_t count = 0;  ///< number of cells
};

/// A change of the verdict between two neighbours of a row of the grid: cells that differ only in
/// the horizontal parameter of the map.
struct MapBoundary {
  std::vector<double> values;  ///< of the row, as SweepCell::values; the horizontal parameter has
                               ///< the midpoint between the neighbours
  SweepVerdict below = SweepVerdict::kHit;  ///< at the smaller value
  SweepVerdict above = SweepVerdict::kHit;
};

/// The verdicts for one planner or careful driver.
struct MapPanel {
  std::string name;  ///< SweepOutcome::name
  bool is_driver = false;
  std::vector<MapTile> tiles;
  /// Sorted by row; empty for a Latin hypercube and if the horizontal parameter has words. A
  /// rejected cell is no neighbour.
  std::vector<MapBoundary> boundaries;
};

/// Pass and fail over two parameters of a sweep, one panel per planner and careful driver.
struct SweepMap {
  bool is_grid = true;
  MapAxis x;
  MapAxis y;
  std::vector<MapPanel> panels;  ///< one without a name if no cell is feasible
};

/// There must be a cell.
SweepMap sweepMap(const SweepLayout& layout, const std::vector<SweepCell>& cells);

/// Returns the file boundary.csv, a row per boundary.
std::string boundaryCsv(const SweepLayout& layout, const SweepMap& map);

}  // namespace forge
