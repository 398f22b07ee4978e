#pragma once

#include <functional>
#include <iosfwd>
#include <vector>

#include "collision_forge/io/drawing/canvas.h"

namespace forge {

/// One picture of an animation.
struct AnimationFrame {
  double time = 0.0;  ///< seconds, on the clock of whoever paints it
  int delay = 0;      ///< hundredths of a second for which it is shown
};

/// Called after each picture that was painted, with how many there are to paint.
using PictureProgress = std::function<void(std::size_t done, std::size_t all)>;

/// Writes a GIF, of frames that all have one size, to a binary stream. Every frame is painted
/// twice, for the shared palette and for the file: that is quicker than it is big to keep them.
/// Throws std::runtime_error for what giflib does not take, and std::invalid_argument for no
/// frames.
void writeAnimation(std::ostream& stream, const std::vector<AnimationFrame>& frames,
                    const std::function<Image(double time)>& paint,
                    const PictureProgress& on_progress = {});

}  // namespace forge
