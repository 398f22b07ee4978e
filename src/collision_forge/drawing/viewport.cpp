#include "collision_forge/drawing/viewport.h"

#include <algorithm>
#include <stdexcept>

namespace forge {

bool PixelRect::contains(const Vector2& pixel) const {
  return pixel.x() >= x && pixel.x() <= x + width && pixel.y() >= y && pixel.y() <= y + height;
}

Viewport::Viewport(const PixelRect& area, const Vector2& center, double pixels_per_metre)
    : area_(area), center_(center), pixels_per_metre_(pixels_per_metre) {}

Vector2 Viewport::toPixel(const Vector2& world) const {
  const Vector2 offset = (world - center_) * pixels_per_metre_;
  return area_.center() + Vector2(offset.x(), -offset.y());
}

Vector2 Viewport::toWorld(const Vector2& pixel) const {
  const Vector2 offset = (pixel - area_.center()) / pixels_per_metre_;
  return center_ + Vector2(offset.x(), -offset.y());
}

Viewport fitViewport(const PixelRect& area, const std::vector<Vector2>& points, double margin,
                     double min_extent) {
  if (points.empty()) throw std::invalid_argument("fitViewport: no points to show");
  Vector2 low = points.front();
  Vector2 high = points.front();
  for (const Vector2& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const Vector2 extent = high - low + Vector2::Constant(2 * margin);
  const double scale = std::min({area.width / extent.x(), area.height / extent.y(),
                                 std::min(area.width, area.height) / min_extent});
  return {area, (low + high) / 2, scale};
}

}  // namespace forge
