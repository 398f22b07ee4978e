#include "collision_forge/planner_test/planners/lead_search.h"

#include <algorithm>
#include <cmath>

namespace forge {
namespace {

constexpr double kSpacing = 0.5;  // m between points on an outline

std::vector<Vector2> outlineOf(const OrientedBox& box) {
  std::vector<Vector2> points;
  const auto ring = corners(box);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector2& from = ring[i];
    const Vector2 side = ring[(i + 1) % ring.size()] - from;
    const int pieces = std::max(1, static_cast<int>(std::ceil(side.norm() / kSpacing)));
    for (int piece = 0; piece < pieces; ++piece) points.push_back(from + side * piece / pieces);
  }
  return points;
}

/// Returns the points of the path between two arc lengths, both included.
std::vector<Vector2> stretchOf(const Polyline& path, double from, double to) {
  std::vector<Vector2> points = {path.poseAt(from).position()};
  const auto& arc_lengths = path.arcLengths();
  const auto first = std::upper_bound(arc_lengths.begin(), arc_lengths.end(), from);
  const auto last = std::lower_bound(first, arc_lengths.end(), to);
  for (auto it = first; it != last; ++it) {
    points.push_back(path.points()[static_cast<std::size_t>(it - arc_lengths.begin())]);
  }
  points.push_back(path.poseAt(to).position());
  return points;
}

/// The corridor ahead of one follower, from its middle on.
class Corridor {
 public:
  Corridor(const Follower& follower, const LeadSearch& search)
      : start_(follower.arc_length),
        length_(0.5 * follower.size.length + search.radius),
        half_width_(0.5 * follower.size.width + search.margin),
        path_(stretchOf(follower.path, start_, start_ + length_)) {}

  /// Returns the arc length on the follower's path at which the box begins; empty if it is not
  /// inside.
  std::optional<double> beginOf(const OrientedBox& box) const {
    if (isOutOfReach(box)) return std::nullopt;
    std::optional<double> begin;
    for (const Vector2& point : outlineOf(box)) {
      const PolylineProjection place = path_.project(point);
      const bool is_inside =
          place.distance <= half_width_ && place.arc_length > 0.0 && place.arc_length < length_;
      if (is_inside && (!begin || place.arc_length < *begin)) begin = place.arc_length;
    }
    if (begin) *begin += start_;
    return begin;
  }

 private:
  /// Quick test: returns true only if the box is certainly outside.
  bool isOutOfReach(const OrientedBox& box) const {
    const double reach = circumradius(box.size);
    const Vector2 away = box.center.position() - path_.points().front();
    if (away.norm() > length_ + reach) return true;
    return path_.project(box.center.position()).distance > half_width_ + reach;
  }

  double start_;
  double length_;
  double half_width_;
  Polyline path_;
};

}  // namespace

std::optional<Lead> findLead(const Follower& follower, const std::string& follower_id,
                             const std::vector<Track>& agents, const LeadSearch& search) {
  const Corridor corridor(follower, search);
  const double front = follower.arc_length + 0.5 * follower.size.length;
  std::optional<Lead> lead;
  for (const Track& agent : agents) {
    if (agent.id == follower_id || agent.states.empty()) continue;
    const AgentState& state = agent.states.back();
    const auto begin = corridor.beginOf(boxAt(agent, state.pose));
    if (!begin) continue;
    const double gap = std::max(*begin - front, 0.0);
    if (lead && gap >= lead->gap) continue;
    lead = Lead{agent.id, gap, state.velocity.dot(follower.path.poseAt(*begin).heading())};
  }
  return lead;
}

}  // namespace forge
