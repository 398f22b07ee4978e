#include "collision_forge/attack/search/lane_paths.h"

#include <algorithm>
#include <cmath>

namespace forge {
namespace {

constexpr double kJointGap = 0.2;          // m; closer points of two lanes are merged
constexpr std::size_t kMaxLanesBack = 50;  // bounds rings of very short lanes

/// Lanes from the place backwards.
struct Chain {
  std::vector<std::size_t> lanes;
  double length = 0.0;
};

void append(const Vector2& point, std::vector<Vector2>& points) {
  if (points.empty() || (point - points.back()).norm() > kJointGap) points.push_back(point);
}

/// Appends the line between two arc lengths, without its last point.
void appendStretch(const Polyline& line, double from, double to, std::vector<Vector2>& points) {
  append(line.poseAt(from).position(), points);
  for (std::size_t i = 0; i < line.points().size(); ++i) {
    const double arc_length = line.arcLengths()[i];
    if (arc_length > from && arc_length < to) append(line.points()[i], points);
  }
}

double turnAlong(const Polyline& line) {
  return std::abs(angleBetween(line.poseAt(0.0).yaw, line.poseAt(line.length()).yaw));
}

}  // namespace

LanePaths::LanePaths(const LaneIndex& lanes)
    : lanes_(lanes), predecessors_(lanes.map().lanes.size()) {
  for (std::size_t lane = 0; lane < predecessors_.size(); ++lane) {
    if (!lanes.centerline(lane)) continue;
    for (const std::size_t next : lanes.successors(lane)) predecessors_[next].push_back(lane);
  }
}

/// Returns the predecessors of a lane, straightest first.
std::vector<std::size_t> LanePaths::before(std::size_t lane) const {
  std::vector<std::size_t> found = predecessors_[lane];
  std::stable_sort(found.begin(), found.end(), [&](std::size_t a, std::size_t b) {
    return turnAlong(*lanes_.centerline(a)) < turnAlong(*lanes_.centerline(b));
  });
  return found;
}

std::vector<Polyline> LanePaths::to(std::size_t lane, double arc_length, double back, double ahead,
                                    std::size_t most) const {
  const std::vector<Vector2> on = lanes_.pathAhead(lane, arc_length, ahead).points();
  std::vector<Chain> chains = {{{lane}, std::min(arc_length, lanes_.centerline(lane)->length())}};
  for (std::size_t i = 0; i < chains.size(); ++i) {
    while (chains[i].length < back && chains[i].lanes.size() < kMaxLanesBack) {
      const std::vector<std::size_t> before = this->before(chains[i].lanes.back());
      if (before.empty()) break;
      for (std::size_t j = before.size(); j-- > 0;) {
        if (j > 0 && chains.size() >= most) continue;
        Chain& chain = j > 0 ? chains.emplace_back(chains[i]) : chains[i];
        chain.lanes.push_back(before[j]);
        chain.length += lanes_.centerline(before[j])->length();
      }
    }
  }
  std::vector<Polyline> ways;
  for (const Chain& chain : chains) {
    std::vector<Vector2> points;
    double from = std::max(0.0, chain.length - back);
    for (std::size_t i = chain.lanes.size(); i-- > 0;) {
      const Polyline& line = *lanes_.centerline(chain.lanes[i]);
      appendStretch(line, from, i > 0 ? line.length() : arc_length, points);
      from = 0.0;
    }
    for (const Vector2& point : on) append(point, points);
    ways.emplace_back(points);
  }
  return ways;
}

}  // namespace forge
