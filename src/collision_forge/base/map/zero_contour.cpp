#include "collision_forge/base/map/zero_contour.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_map>

#include "collision_forge/base/geometry/simplified_line.h"

namespace forge {
namespace {

constexpr double kTolerance = 0.02;  // m, simplification of rings

using Ring = std::vector<Vector2>;

/// Returns the area of a ring, m2, positive if it is counterclockwise.
double signedArea(const Ring& ring) {
  double twice = 0.0;
  const Vector2& first = ring.front();  // keeps the products small
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const Vector2 a = ring[i] - first;
    const Vector2 b = ring[i + 1] - first;
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

/// Traces the border of the positive area, with the area on its left.
class ContourTracer {
 public:
  explicit ContourTracer(const ValueGrid& grid) : grid_(grid) {
    for (int row = 0; row + 1 < grid.rows; ++row) {
      for (int column = 0; column + 1 < grid.columns; ++column) addCell(column, row);
    }
  }

  std::vector<Ring> rings() {
    std::vector<Ring> rings;
    for (const CellSide start : starts_) {
      Ring ring;
      for (auto step = next_.find(start); step != next_.end();) {
        const CellSide side = step->first;
        ring.push_back(crossing(side));
        const CellSide following = step->second;
        next_.erase(step);
        step = next_.find(following);
      }
      if (!ring.empty()) rings.push_back(std::move(ring));
    }
    return rings;
  }

 private:
  /// A side of a cell that the border crosses: its first node, doubled, plus 1 if it is vertical.
  using CellSide = std::int64_t;

  CellSide horizontal(int column, int row) const { return 2 * indexOf(column, row); }
  CellSide vertical(int column, int row) const { return 2 * indexOf(column, row) + 1; }
  std::int64_t indexOf(int column, int row) const {
    return std::int64_t{row} * grid_.columns + column;
  }

  double value(int column, int row) const {
    const bool is_border =
        column == 0 || row == 0 || column + 1 == grid_.columns || row + 1 == grid_.rows;
    const double value = grid_.values[static_cast<std::size_t>(indexOf(column, row))];
    return is_border ? std::min(value, -grid_.spacing) : value;
  }

  void link(CellSide from, CellSide to) {
    next_.emplace(from, to);
    starts_.push_back(from);
  }

  /// Walks the four sides of a cell counterclockwise. The border leaves the cell where positive
  /// follows negative and enters it where negative follows positive; of four crossings, neighbours
  /// around a positive node belong together.
  void addCell(int column, int row) {
    const std::array<bool, 4> inside = {value(column, row) > 0.0, value(column + 1, row) > 0.0,
                                        value(column + 1, row + 1) > 0.0,
                                        value(column, row + 1) > 0.0};
    const std::array<CellSide, 4> sides = {horizontal(column, row), vertical(column + 1, row),
                                           horizontal(column, row + 1), vertical(column, row)};
    for (std::size_t i = 0; i < 4; ++i) {
      if (!inside[i] || inside[(i + 1) % 4]) continue;
      std::size_t entry = (i + 3) % 4;  // the side before the run of positive nodes that ends at i
      while (inside[entry]) entry = (entry + 3) % 4;
      link(sides[i], sides[entry]);
    }
  }

  Vector2 crossing(CellSide side) const {
    const std::int64_t node = side / 2;
    const int column = static_cast<int>(node % grid_.columns);
    const int row = static_cast<int>(node / grid_.columns);
    const bool is_vertical = side % 2 == 1;
    const double from = value(column, row);
    const double to = is_vertical ? value(column, row + 1) : value(column + 1, row);
    const double share = from / (from - to);
    const Vector2 place(column + (is_vertical ? 0.0 : share), row + (is_vertical ? share : 0.0));
    return grid_.origin + grid_.spacing * place;
  }

  const ValueGrid& grid_;
  std::unordered_map<CellSide, CellSide> next_;
  std::vector<CellSide> starts_;  // in the order of the cells, so that rings come in a fixed order
};

/// Starts at the first point whatever the ring's shape there.
Ring simplifiedRing(Ring ring) {
  ring.push_back(ring.front());
  Ring kept = simplified(ring, kTolerance);
  kept.pop_back();
  return kept;
}

/// Adds each hole to the smallest polygon around it.
void addHoles(std::vector<Ring> holes, std::vector<Polygon>& polygons) {
  for (Ring& hole : holes) {
    Polygon* around = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (Polygon& polygon : polygons) {
      const double area = signedArea(polygon.exterior);
      if (area >= least || !contains({polygon.exterior, {}}, hole.front())) continue;
      least = area;
      around = &polygon;
    }
    if (around) around->holes.push_back(std::move(hole));
  }
}

}  // namespace

std::vector<Polygon> positiveArea(const ValueGrid& grid, double min_area) {
  std::vector<Polygon> polygons;
  std::vector<Ring> holes;
  for (Ring& traced : ContourTracer(grid).rings()) {
    Ring ring = simplifiedRing(std::move(traced));
    if (ring.size() < 3) continue;
    const double area = signedArea(ring);
    if (area >= min_area) polygons.push_back({std::move(ring), {}});
    if (-area >= min_area) holes.push_back(std::move(ring));
  }
  addHoles(std::move(holes), polygons);
  return polygons;
}

}  // namespace forge
