#pragma once

#include <Eigen/Geometry>
#include <atomic>
#include <bitset>
#include <memory>
#include <vector>

#include "collision_forge/base/geometry/polygon.h"

namespace forge {

/// Answers point-in-area queries quickly, to half a cell: rasterises the union of polygons into
/// cells of 0.5 m, aligned to multiples of 0.5 m in the map frame. Tiles are filled on first use.
/// Thread-safe.
class AreaRaster {
 public:
  /// Rasterises the union of the polygons `area`, metres in the map frame, which must outlive the
  /// raster unchanged. Throws std::invalid_argument if it extends over more than 200 km.
  explicit AreaRaster(const std::vector<Polygon>& area);
  ~AreaRaster();
  AreaRaster(const AreaRaster&) = delete;
  AreaRaster& operator=(const AreaRaster&) = delete;

  /// Returns true if the area has no polygon.
  bool empty() const { return area_.empty(); }
  /// Returns true if the centre of the cell with this point (m, map frame) is in the area; false
  /// for a point that is not finite, and for an empty area.
  bool contains(const Vector2& point) const;

 private:
  static constexpr int kCells = 64;  // cells per side of a tile
  using Tile = std::bitset<kCells * kCells>;

  /// Returns a tile, which is filled on first use; `corner`: its smallest x and y, m.
  const Tile& tileAt(std::size_t index, const Vector2& corner) const;
  /// Returns the tile with this corner, with a bit set for each cell whose centre is in the area.
  std::unique_ptr<const Tile> fill(const Vector2& corner) const;

  const std::vector<Polygon>& area_;
  std::vector<Eigen::AlignedBox2d> bounds_;  // one per polygon
  Vector2 origin_ = Vector2::Zero();
  int columns_ = 0;
  int rows_ = 0;
  mutable std::vector<std::atomic<const Tile*>> tiles_;  // owned; null until first use
};

}  // namespace forge
