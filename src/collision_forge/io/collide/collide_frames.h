#pragma once

#include <vector>

namespace forge {

/// Returns true if the median (of an even number: the upper one) interval of ascending frame times
/// (s) is within 0.05 s of kCollideFrameInterval, so that consecutive frames can be consecutive
/// frames of a clip; true for fewer than two times.
bool areCollideFrames(const std::vector<double>& times);

/// Returns the elements of ascending frame times (s) that can be frames of clips: all if
/// areCollideFrames(), else the nearest one (of equally near ones the earlier) to each of the times
/// first + i * kCollideFrameInterval, i from 0 to (last - first) / kCollideFrameInterval rounded to
/// the nearest, halves up, each element at most once. An empty input gives none.
std::vector<double> collideFrames(const std::vector<double>& times);

/// Returns the times (s, ascending) `now` + i * kCollideFrameInterval for i = `from` to `to`, both
/// included. A time that is within 1 ms of an element of `times`, the recorded frames (s,
/// ascending, not empty), is exactly that element.
std::vector<double> collideGrid(const std::vector<double>& times, double now, int from, int to);

}  // namespace forge
