#pragma once

#include <Eigen/Geometry>
#include <atomic>
#include <bitset>
#include <memory>
#include <vector>

#include "collision_forge/base/geometry/polygon.h"

namespace forge {

/// The union of some polygons as cells of half a metre, at half metres of the map's frame: for many
/// questions that may be half a cell wrong. Tiles are filled when first asked for. Thread-safe.
class AreaRaster {
 public:
  /// The polygons must outlive the raster. Throws std::invalid_argument beyond 100 km.
  explicit AreaRaster(const std::vector<Polygon>& area);
  ~AreaRaster();
  AreaRaster(const AreaRaster&) = delete;
  AreaRaster& operator=(const AreaRaster&) = delete;

  /// True without any polygon.
  bool empty() const { return area_.empty(); }
  bool contains(const Vector2& point) const;

 private:
  static constexpr int kCells = 64;  // a side of a tile
  using Tile = std::bitset<kCells * kCells>;

  const Tile& tileAt(std::size_t index, const Vector2& corner) const;
  std::unique_ptr<const Tile> fill(const Vector2& corner) const;

  const std::vector<Polygon>& area_;
  std::vector<Eigen::AlignedBox2d> bounds_;  // one a polygon
  Vector2 origin_ = Vector2::Zero();
  int columns_ = 0;
  int rows_ = 0;
  mutable std::vector<std::atomic<const Tile*>> tiles_;  // owned; null until asked for
};

}  // namespace forge
