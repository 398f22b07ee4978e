#pragma once

#include <vector>

#include "collision_forge/io/drawing/viewport.h"

namespace forge {

/// Places labels beside the points that they name. Pixels throughout.
class LabelPlacer {
 public:
  /// Labels are kept inside `area`.
  explicit LabelPlacer(const PixelRect& area) : area_(area) {}

  /// Marks a pixel as an obstacle for later labels.
  void avoid(const Vector2& pixel) { obstacles_.push_back(pixel); }

  /// Returns a rectangle of the given size near `anchor` that covers the fewest obstacles; of equal
  /// ones, a near one; all places are 1.2 to 3.6 heights beside `anchor`. A place outside of the
  /// area is taken only if all are. The rectangle becomes an obstacle for later labels.
  PixelRect place(const Vector2& anchor, double width, double height);

 private:
  /// Returns the number of obstacles in and around a place, and a large number for a place outside
  /// of the area.
  double cost(const PixelRect& rect) const;
  /// Marks the area of a label as an obstacle.
  void avoid(const PixelRect& rect);

  PixelRect area_;
  std::vector<Vector2> obstacles_;
};

}  // namespace forge
