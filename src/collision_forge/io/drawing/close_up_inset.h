#pragma once

#include <optional>
#include <vector>

#include "collision_forge/io/drawing/scene_painter.h"

namespace forge {

/// The contact from near, in a corner of a picture where its vehicles are small; after the contact
/// it follows them. The scene and the options must outlive it.
class CloseUpInset {
 public:
  /// `area` is a square of whole pixels.
  CloseUpInset(const ScenePainter& scene, const PixelRect& area, const DrawingOptions& options);

  /// Everybody at `time`, and around them a frame.
  void paint(Canvas& canvas, double time) const;

 private:
  const ScenePainter& scene_;
  const DrawingOptions& options_;
  PixelRect area_;
  LineStyle frame_;
  Image ground_;  ///< at the contact
};

/// The corner of `area` for a square of `side` pixels, `gap` off its edges, that covers the fewest
/// of the points (pixels); of equal ones the upper right, then the upper left.
PixelRect freeCorner(const PixelRect& area, double side, double gap,
                     const std::vector<Vector2>& points);

}  // namespace forge
