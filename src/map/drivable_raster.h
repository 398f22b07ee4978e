#pragma once

#include <Eigen/Geometry>
#include <atomic>
#include <bitset>
#include <memory>
#include <vector>

#include "map/lane_map.h"

namespace forge {

/// The drivable area as cells of half a metre, for questions that are asked thousands of times and
/// may be half a cell wrong. Tiles are filled when they are first asked for. Thread-safe.
class DrivableRaster {
 public:
  /// The map must outlive the raster.
  explicit DrivableRaster(const LaneMap& map);
  ~DrivableRaster();
  DrivableRaster(const DrivableRaster&) = delete;
  DrivableRaster& operator=(const DrivableRaster&) = delete;

  /// False when the map has no drivable area: then nothing is known.
  bool known() const { return !map_.drivable_area.empty(); }
  bool isDrivable(const Vector2& point) const;

 private:
  static constexpr int kCells = 64;  // a side of a tile
  using Tile = std::bitset<kCells * kCells>;

  const Tile& tileAt(std::size_t index, const Vector2& corner) const;
  std::unique_ptr<const Tile> fill(const Vector2& corner) const;

  const LaneMap& map_;
  std::vector<Eigen::AlignedBox2d> bounds_;  // one a polygon
  Vector2 origin_ = Vector2::Zero();
  int columns_ = 0;
  int rows_ = 0;
  mutable std::vector<std::atomic<const Tile*>> tiles_;  // owned; null until asked for
};

}  // namespace forge
