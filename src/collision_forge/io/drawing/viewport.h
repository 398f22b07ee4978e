#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "collision_forge/base/geometry/pose2.h"

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

/// Maps the ground (metres, y north) onto a rectangle of the picture (pixels, y down), at the same
/// scale along both axes.
class Viewport {
 public:
  /// `center` (metres) falls on the middle of `area`. The direction `rightwards` (radians from
  /// east) points to the right in the picture; with 0 north is up.
  Viewport(const PixelRect& area, const Vector2& center, double pixels_per_metre,
           double rightwards = 0.0);

  Vector2 toPixel(const Vector2& world) const;
  Vector2 toWorld(const Vector2& pixel) const;

  /// The same ground at the same scale around the middle of another area.
  Viewport movedTo(const PixelRect& area) const;

  const PixelRect& area() const { return area_; }
  double pixelsPerMetre() const { return pixels_per_metre_; }

 private:
  PixelRect area_;
  Vector2 center_;
  double pixels_per_metre_;
  Eigen::Rotation2Dd to_picture_;
};

/// The largest scale at which all `points` lie at least `margin` metres inside `area`, never
/// showing less than `min_extent` metres along the shorter side. `rightwards`: as of Viewport.
/// Throws std::invalid_argument for no points.
Viewport fitViewport(const PixelRect& area, const std::vector<Vector2>& points, double margin,
                     double min_extent, double rightwards = 0.0);

}  // namespace forge
