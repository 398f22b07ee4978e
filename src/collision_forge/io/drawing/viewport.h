#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "collision_forge/base/geometry/pose2.h"

namespace forge {

/// A rectangle of a picture, pixels, y down.
struct PixelRect {
  double x = 0.0;  ///< left edge
  double y = 0.0;  ///< upper edge
  double width = 0.0;
  double height = 0.0;

  /// Returns the middle of the rectangle.
  Vector2 center() const { return {x + width / 2, y + height / 2}; }
  /// Returns true if the pixel is in the rectangle, edges included.
  bool contains(const Vector2& pixel) const;
};

/// Maps the ground (map frame, metres) to a rectangle of a picture (pixels, y down), with one scale
/// for both axes.
class Viewport {
 public:
  /// `center` (m) maps to the middle of `area`. `rightwards`: direction on the ground, rad
  /// counterclockwise from east (the map's x axis), that points right in the picture; with 0, north
  /// is up.
  Viewport(const PixelRect& area, const Vector2& center, double pixels_per_metre,
           double rightwards = 0.0);

  /// Returns the pixel of a point on the ground (m, map frame), inside or outside of area().
  Vector2 toPixel(const Vector2& world) const;
  /// Returns the point on the ground (m, map frame) of a pixel.
  Vector2 toWorld(const Vector2& pixel) const;

  /// Returns the mapping with the same scale and centre in another area.
  Viewport movedTo(const PixelRect& area) const;

  /// Returns the rectangle of the picture.
  const PixelRect& area() const { return area_; }
  double pixelsPerMetre() const { return pixels_per_metre_; }

 private:
  PixelRect area_;
  Vector2 center_;  ///< m, map frame
  double pixels_per_metre_;
  Eigen::Rotation2Dd to_picture_;  ///< from the map's axes to right and up in the picture
};

/// Returns the mapping with the largest scale at which all `points` are at least `margin` (m)
/// inside `area` and the shorter side shows at least `min_extent` (m). `rightwards` as in Viewport.
/// Throws std::invalid_argument if there are no points. The middle of the points' extent,
/// measured along the axes of the picture, is at the middle of `area`. `points`: m, map frame.
Viewport fitViewport(const PixelRect& area, const std::vector<Vector2>& points, double margin,
                     double min_extent, double rightwards = 0.0);

}  // namespace forge
