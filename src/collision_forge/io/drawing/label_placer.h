#pragma once

#include <vector>

#include "collision_forge/io/drawing/viewport.h"

namespace forge {

/// Finds room for short texts beside the points they name. Pixels throughout.
class LabelPlacer {
 public:
  /// Labels are kept inside `area`.
  explicit LabelPlacer(const PixelRect& area) : area_(area) {}

  /// Later labels keep off this pixel where they can.
  void avoid(const Vector2& pixel) { obstacles_.push_back(pixel); }

  /// A place of the given size near `anchor` that covers as few obstacles as possible, the nearest
  /// such place. Later labels keep off it.
  PixelRect place(const Vector2& anchor, double width, double height);

 private:
  double cost(const PixelRect& rect) const;
  void avoid(const PixelRect& rect);

  PixelRect area_;
  std::vector<Vector2> obstacles_;
};

}  // namespace forge
