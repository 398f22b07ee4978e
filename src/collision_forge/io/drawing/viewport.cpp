#include "collision_forge/io/drawing/viewport.h"

#include <algorithm>
#include <stdexcept>

namespace forge {

bool PixelRect::contains(const Vector2& pixel) const {
  return pixel.x() >= x && pixel.x() <= x + width && pixel.y() >= y && pixel.y() <= y + height;
}

Viewport::Viewport(const PixelRect& area, const Vector2& center, double pixels_per_metre,
                   double rightwards)
    : area_(area), center_(center), pixels_per_metre_(pixels_per_metre), to_picture_(-rightwards) {}

Vector2 Viewport::toPixel(const Vector2& world) const {
  const Vector2 offset = to_picture_ * (world - center_) * pixels_per_metre_;
  return area_.center() + Vector2(offset.x(), -offset.y());
}

Vector2 Viewport::toWorld(const Vector2& pixel) const {
  const Vector2 offset = (pixel - area_.center()) / pixels_per_metre_;
  return center_ + to_picture_.inverse() * Vector2(offset.x(), -offset.y());
}

Viewport Viewport::movedTo(const PixelRect& area) const {
  Viewport moved(*this);
  moved.area_ = area;
  return moved;
}

Viewport fitViewport(const PixelRect& area, const std::vector<Vector2>& points, double margin,
                     double min_extent, double rightwards) {
  if (points.empty()) throw std::invalid_argument("fitViewport: no points to show");
  const Eigen::Rotation2Dd to_picture(-rightwards);
  Eigen::AlignedBox2d shown;
  for (const Vector2& point : points) shown.extend(Vector2(to_picture * point));
  const Vector2 extent = shown.sizes() + Vector2::Constant(2 * margin);
  const double scale = std::min({area.width / extent.x(), area.height / extent.y(),
                                 std::min(area.width, area.height) / min_extent});
  return {area, to_picture.inverse() * shown.center(), scale, rightwards};
}

}  // namespace forge
