#include "collision_forge/io/collide/collide_frames.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "collision_forge/io/collide/collide_clip.h"

namespace forge {
namespace {

/// Returns the time nearest to `time`; `times` must not be empty.
double nearestTo(double time, const std::vector<double>& times) {
  const auto after = std::lower_bound(times.begin(), times.end(), time);
  if (after == times.end()) return times.back();
  if (after == times.begin()) return times.front();
  return *after - time < time - *std::prev(after) ? *after : *std::prev(after);
}

}  // namespace

bool areCollideFrames(const std::vector<double>& times) {
  constexpr double kSpread = 0.05;  // s
  if (times.size() < 2) return true;
  std::vector<double> intervals;
  for (std::size_t i = 1; i < times.size(); ++i) intervals.push_back(times[i] - times[i - 1]);
  const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
  std::nth_element(intervals.begin(), middle, intervals.end());
  return std::abs(*middle - kCollideFrameInterval) <= kSpread;
}

std::vector<double> collideFrames(const std::vector<double>& times) {
  if (areCollideFrames(times)) return times;
  std::vector<double> frames;
  const auto last = std::lround((times.back() - times.front()) / kCollideFrameInterval);
  for (long i = 0; i <= last; ++i) {
    const double frame =
        nearestTo(times.front() + static_cast<double>(i) * kCollideFrameInterval, times);
    if (frames.empty() || frame > frames.back()) frames.push_back(frame);
  }
  return frames;
}

std::vector<double> collideGrid(const std::vector<double>& times, double now, int from, int to) {
  constexpr double kSameFrame = 1e-3;  // s
  std::vector<double> grid;
  for (int i = from; i <= to; ++i) {
    const double time = now + i * kCollideFrameInterval;
    const double frame = nearestTo(time, times);
    grid.push_back(std::abs(frame - time) <= kSameFrame ? frame : time);
  }
  return grid;
}

}  // namespace forge
