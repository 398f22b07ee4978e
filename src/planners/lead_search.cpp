#include "planners/lead_search.h"

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

/// The corridor ahead of one follower.
class Corridor {
 public:
  Corridor(const Follower& follower, const LeadSearch& search)
      : follower_(follower),
        half_width_(0.5 * follower.size.width + search.margin),
        end_(follower.arc_length + 0.5 * follower.size.length + search.radius) {}

  bool isOutOfReach(const OrientedBox& box) const {
    const double reach = circumradius(box.size);
    const double ahead = end_ - follower_.arc_length + reach;
    const Vector2 here = follower_.path.poseAt(follower_.arc_length).position();
    if ((box.center.position() - here).norm() > ahead) return true;
    return follower_.path.project(box.center.position()).distance > half_width_ + reach;
  }

  /// Arc length at which the box begins; empty when it is not in the corridor.
  std::optional<double> beginOf(const OrientedBox& box) const {
    std::optional<double> begin;
    for (const Vector2& point : outlineOf(box)) {
      const PolylineProjection place = follower_.path.project(point);
      const bool is_inside = place.distance <= half_width_ &&
                             place.arc_length > follower_.arc_length && place.arc_length <= end_;
      if (is_inside && (!begin || place.arc_length < *begin)) begin = place.arc_length;
    }
    return begin;
  }

 private:
  const Follower& follower_;
  double half_width_;
  double end_;
};

}  // namespace

std::optional<Lead> findLead(const Follower& follower, const std::string& follower_id,
                             const std::vector<Track>& others, const LeadSearch& search) {
  const Corridor corridor(follower, search);
  const double front = follower.arc_length + 0.5 * follower.size.length;
  std::optional<Lead> lead;
  for (const Track& other : others) {
    if (other.id == follower_id || other.states.empty()) continue;
    const AgentState& state = other.states.back();
    const OrientedBox box = boxAt(other, state.pose);
    if (corridor.isOutOfReach(box)) continue;
    const auto begin = corridor.beginOf(box);
    if (!begin) continue;
    const double gap = std::max(*begin - front, 0.0);
    if (lead && gap >= lead->gap) continue;
    lead = Lead{other.id, gap, state.velocity.dot(follower.path.poseAt(*begin).heading())};
  }
  return lead;
}

}  // namespace forge
