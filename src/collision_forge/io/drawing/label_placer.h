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

  /// Returns a place of the given size near `anchor` that covers the fewest obstacles, the nearest
  /// such place. It becomes an obstacle for later labels.
  PixelRect place(const Vector2& anchor, double width, double height);

 private:
  double cost(const PixelRect& rect) const;
  void avoid(const PixelRect& rect);

  PixelRect area_;
  std::vector<Vector2> obstacles_;
};

}  // namespace forge
