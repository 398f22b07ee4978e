#pragma once

#include <functional>
#include <iosfwd>
#include <vector>

#include "collision_forge/io/drawing/canvas.h"

namespace forge {

/// One picture of an animation.
struct AnimationFrame {
  double time = 0.0;  ///< s, on the clock of `paint`: the argument of `paint`
  int delay = 0;      ///< display time, hundredths of a second
};

/// Writes a GIF of frames of equal size (not checked), in the given order, to a binary stream.
/// Calls `paint` twice per frame, for the shared palette and for the file, which needs less memory
/// than to keep the frames. Failed writes are reported by the stream's state alone (badbit),
/// without an exception unless the stream is set to throw. Throws std::runtime_error for an error
/// of giflib, std::invalid_argument if there are no frames; passes on what `paint` throws.
void writeAnimation(std::ostream& stream, const std::vector<AnimationFrame>& frames,
                    const std::function<Image(double time)>& paint);

}  // namespace forge
