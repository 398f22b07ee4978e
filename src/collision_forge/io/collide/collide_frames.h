#pragma once

#include <vector>

namespace forge {

/// Returns true if the median interval of ascending frame times (s) is about the interval of
/// COLLIDE, so that consecutive frames can be consecutive frames of a clip.
bool areCollideFrames(const std::vector<double>& times);

/// Returns the elements of ascending frame times (s) that can be frames of clips: all if
/// areCollideFrames(), else the nearest one to each multiple of kCollideFrameInterval after the
/// first.
std::vector<double> collideFrames(const std::vector<double>& times);

/// Returns the times (s) `from` to `to` intervals of kCollideFrameInterval after `now`; a time that
/// is a recorded frame's to 1 ms is exactly the frame's.
std::vector<double> collideGrid(const std::vector<double>& times, double now, int from, int to);

}  // namespace forge
