#include "collision_forge/base/map/area_raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace forge {
namespace {

constexpr double kCell = 0.5;     // m, side of a cell
constexpr double kLargest = 2e5;  // m, largest extent

/// Adds where a ring crosses the centre line of each row of cells, in cells from the tile's left.
template <std::size_t kRows>
void addCrossings(const std::vector<Vector2>& ring, const Vector2& corner,
                  std::array<std::vector<double>, kRows>& crossings) {
  if (ring.empty()) return;
  Vector2 a = (ring.back() - corner) / kCell;
  for (const Vector2& point : ring) {
    const Vector2 b = (point - corner) / kCell;
    const double low = std::min(a.y(), b.y());
    const double high = std::max(a.y(), b.y());
    const auto last_row = static_cast<double>(kRows);
    const auto first = static_cast<std::size_t>(std::clamp(std::ceil(low - 0.5), 0.0, last_row));
    const auto end = static_cast<std::size_t>(std::clamp(std::ceil(high - 0.5), 0.0, last_row));
    for (std::size_t row = first; row < end; ++row) {
      const double ratio = (static_cast<double>(row) + 0.5 - a.y()) / (b.y() - a.y());
      crossings[row].push_back(a.x() + ratio * (b.x() - a.x()));
    }
    a = b;
  }
}

}  // namespace

AreaRaster::AreaRaster(const std::vector<Polygon>& area) : area_(area) {
  Eigen::AlignedBox2d all;
  for (const Polygon& polygon : area) {
    bounds_.emplace_back();
    for (const Vector2& point : polygon.exterior) bounds_.back().extend(point);
    all.extend(bounds_.back());
  }
  if (all.isEmpty()) return;
  if (!(all.sizes().maxCoeff() <= kLargest)) {
    std::ostringstream complaint;
    complaint << "area of " << all.sizes().x() << " x " << all.sizes().y()
              << " m is above the limit of 200 km";
    throw std::invalid_argument(complaint.str());
  }
  // Aligned to whole tiles of the map frame, so that a crop of the map has the same cells.
  constexpr double kTile = kCell * kCells;
  origin_ = (all.min() / kTile).array().floor() * kTile;
  const Vector2 tiles = ((all.max() - origin_) / kTile).array().floor() + 1.0;
  columns_ = static_cast<int>(tiles.x());
  rows_ = static_cast<int>(tiles.y());
  tiles_ = std::vector<std::atomic<const Tile*>>(static_cast<std::size_t>(columns_) *
                                                 static_cast<std::size_t>(rows_));
}

AreaRaster::~AreaRaster() {
  for (const auto& tile : tiles_) delete tile.load();
}

bool AreaRaster::contains(const Vector2& point) const {
  const Vector2 cell = (point - origin_) / kCell;
  const bool is_within = cell.x() >= 0.0 && cell.y() >= 0.0 && cell.x() < columns_ * kCells &&
                         cell.y() < rows_ * kCells;
  if (!is_within) return false;
  // The coordinates are not negative, so the conversion rounds down.
  const int column = static_cast<int>(cell.x());
  const int row = static_cast<int>(cell.y());
  const Vector2 tile(column / kCells, row / kCells);
  const std::size_t index =
      static_cast<std::size_t>(row / kCells) * static_cast<std::size_t>(columns_) +
      static_cast<std::size_t>(column / kCells);
  return tileAt(
      index,
      origin_ + tile * (kCell *
                        kCells))[static_cast<std::size_t>(row % kCells * kCells + column % kCells)];
}

const AreaRaster::Tile& AreaRaster::tileAt(std::size_t index, const Vector2& corner) const {
  std::atomic<const Tile*>& slot = tiles_[index];
  const Tile* tile = slot.load();
  if (tile) return *tile;
  std::unique_ptr<const Tile> filled = fill(corner);
  // If another thread was faster, its tile is used.
  if (slot.compare_exchange_strong(tile, filled.get())) tile = filled.release();
  return *tile;
}

std::unique_ptr<const AreaRaster::Tile> AreaRaster::fill(const Vector2& corner) const {
  const Eigen::AlignedBox2d area(corner, corner + Vector2::Constant(kCell * kCells));
  auto tile = std::make_unique<Tile>();
  for (std::size_t i = 0; i < bounds_.size(); ++i) {
    if (!bounds_[i].intersects(area)) continue;
    std::array<std::vector<double>, kCells> crossings;
    addCrossings(area_[i].exterior, corner, crossings);
    for (const std::vector<Vector2>& hole : area_[i].holes) {
      addCrossings(hole, corner, crossings);
    }
    for (std::size_t row = 0; row < kCells; ++row) {
      std::sort(crossings[row].begin(), crossings[row].end());
      for (std::size_t pair = 0; pair + 1 < crossings[row].size(); pair += 2) {
        const auto cellFrom = [](double x) {
          return static_cast<std::size_t>(std::clamp(std::ceil(x - 0.5), 0.0, double{kCells}));
        };
        const std::size_t end = cellFrom(crossings[row][pair + 1]);
        for (std::size_t x = cellFrom(crossings[row][pair]); x < end; ++x) {
          tile->set(row * kCells + x);
        }
      }
    }
  }
  return tile;
}

}  // namespace forge
