#pragma once

#include <optional>
#include <vector>

#include "collision_forge/io/drawing/scene_painter.h"

namespace forge {

/// Paints a close-up of the contact into a corner of a picture whose vehicles are small; after the
/// contact it follows them. The scene and the options must outlive it.
class CloseUpInset {
 public:
  /// `area`: a square of whole pixels.
  CloseUpInset(const ScenePainter& scene, const PixelRect& area, const DrawingOptions& options);

  /// Paints the scene at `time` (s, scene's clock) with a frame around it.
  void paint(Canvas& canvas, double time) const;

 private:
  const ScenePainter& scene_;
  const DrawingOptions& options_;
  PixelRect area_;
  LineStyle frame_;
  Image ground_;  ///< map around the contact
};

/// Returns the place of a square of `side` pixels in a corner of `area`, `gap` pixels off the
/// edges, that covers the fewest of the points (pixels); of equal ones the upper right, then upper
/// left.
PixelRect freeCorner(const PixelRect& area, double side, double gap,
                     const std::vector<Vector2>& points);

}  // namespace forge
