#pragma once

#include <vector>

#include "collision_forge/geometry/pose2.h"

namespace forge {

/// A rectangle of the picture, pixels, y down.
struct PixelRect {
  double x = 0.0;  ///< left edge
  double y = 0.0;  ///< upper edge
  double width = 0.0;
  double height = 0.0;

  Vector2 center() const { return {x + width / 2, y + height / 2}; }
  bool contains(const Vector2& pixel) const;
};

/// Maps the ground (metres, y north) onto a rectangle of the picture (pixels, y down): north up and
/// the same scale along both axes.
class Viewport {
 public:
  /// `center` (metres) falls on the middle of `area`.
  Viewport(const PixelRect& area, const Vector2& center, double pixels_per_metre);

  Vector2 toPixel(const Vector2& world) const;
  Vector2 toWorld(const Vector2& pixel) const;

  const PixelRect& area() const { return area_; }
  double pixelsPerMetre() const { return pixels_per_metre_; }

 private:
  PixelRect area_;
  Vector2 center_;
  double pixels_per_metre_;
};

/// The largest scale at which all `points` lie at least `margin` metres inside `area`, never
/// showing less than `min_extent` metres along the shorter side. Throws std::invalid_argument for
/// no points.
Viewport fitViewport(const PixelRect& area, const std::vector<Vector2>& points, double margin,
                     double min_extent);

}  // namespace forge
