#include "collision_forge/io/export/road_sidewalks.h"

#include <algorithm>
#include <cmath>

namespace forge {
namespace {

// Own choice.
constexpr double kSpacing = 2.0;     // m between the places of a sidewalk
constexpr double kFarthest = 3.0;    // m from the outermost lane: a row of parked vehicles fits
constexpr double kWidest = 5.0;      // m; wider walkways are squares
constexpr double kNarrowest = 0.5;   // m
constexpr double kLeastShare = 0.7;  // of the road
constexpr double kTolerance = 0.1;   // m, of gap and width between the places

/// Removes places between which gap and width are linear to kTolerance.
Sidewalk thinned(const Sidewalk& fine) {
  Sidewalk thin;
  thin.is_gap_drivable = fine.is_gap_drivable;
  const auto isBetween = [&](const std::vector<double>& values, std::size_t from, std::size_t to) {
    for (std::size_t i = from + 1; i < to; ++i) {
      const double share = (fine.at[i] - fine.at[from]) / (fine.at[to] - fine.at[from]);
      const double value = values[from] + share * (values[to] - values[from]);
      if (std::abs(value - values[i]) > kTolerance) return false;
    }
    return true;
  };
  for (std::size_t from = 0; from < fine.at.size();) {
    thin.at.push_back(fine.at[from]);
    thin.gap.push_back(fine.gap[from]);
    thin.width.push_back(fine.width[from]);
    std::size_t to = from + 1;
    while (to + 1 < fine.at.size() && isBetween(fine.gap, from, to + 1) &&
           isBetween(fine.width, from, to + 1)) {
      ++to;
    }
    from = to;
  }
  return thin;
}

}  // namespace

SidewalkFinder::SidewalkFinder(const LaneMap& map) : map_(map) {
  for (const Polygon& walkway : map.walkways) {
    Eigen::AlignedBox2d box;
    for (const Vector2& corner : walkway.exterior) box.extend(corner);
    boxes_.push_back(box);
  }
}

/// Returns the first part of the polygon on the line from `start` in `direction` (a unit vector).
std::optional<SidewalkFinder::Crossing> SidewalkFinder::crossingOf(const Polygon& polygon,
                                                                   const Vector2& start,
                                                                   const Vector2& direction) {
  std::vector<double> cuts;
  const std::vector<Vector2>& ring = polygon.exterior;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector2 a = ring[i] - start, b = ring[(i + 1) % ring.size()] - start;
    const double side_a = direction.x() * a.y() - direction.y() * a.x();
    const double side_b = direction.x() * b.y() - direction.y() * b.x();
    if ((side_a > 0.0) == (side_b > 0.0)) continue;
    const double cut = direction.dot(a + (b - a) * (side_a / (side_a - side_b)));
    if (cut > 0.0) cuts.push_back(cut);
  }
  if (cuts.empty()) return std::nullopt;
  std::sort(cuts.begin(), cuts.end());
  if (cuts.size() % 2 == 1) return Crossing{0.0, cuts[0]};
  return Crossing{cuts[0], cuts[1]};
}

std::optional<SidewalkFinder::Crossing> SidewalkFinder::nearestCrossing(
    const Vector2& start, const Vector2& direction) const {
  std::optional<Crossing> nearest;
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    if (boxes_[i].exteriorDistance(start) > kFarthest) continue;
    const std::optional<Crossing> one = crossingOf(map_.walkways[i], start, direction);
    if (!one || one->from > kFarthest || one->to - one->from < kNarrowest) continue;
    if (!nearest || one->from < nearest->from) nearest = one;
  }
  return nearest;
}

bool SidewalkFinder::isDrivable(const Vector2& place) const {
  return std::any_of(map_.drivable_area.begin(), map_.drivable_area.end(),
                     [&](const Polygon& area) { return contains(area, place); });
}

Sidewalk SidewalkFinder::along(const Road& road, int side) const {
  const std::vector<RoadLane>& lanes = side < 0 ? road.right : road.left;
  if (road.junction != 0 || map_.walkways.empty() || lanes.empty()) return {};
  const double length = road.course.length();
  const int count = std::max(1, static_cast<int>(std::ceil(length / kSpacing)));
  Sidewalk sidewalk;
  int found = 0, drivable = 0;
  for (int i = 0; i <= count; ++i) {
    const double at = length * i / count;
    const Pose2 border =
        compose(road.course.poseAt(at), {0.0, road.borderAt(lanes.back().id, at), 0.0});
    const Vector2 outwards(-side * std::sin(border.yaw), side * std::cos(border.yaw));
    const auto crossing = nearestCrossing(border.position(), outwards);
    sidewalk.at.push_back(at);
    sidewalk.gap.push_back(crossing ? crossing->from : i == 0 ? 0.0 : sidewalk.gap.back());
    sidewalk.width.push_back(crossing ? std::min(kWidest, crossing->to - crossing->from) : 0.0);
    if (!crossing) continue;
    ++found;
    if (crossing->from > kTolerance)
      drivable += isDrivable(border.position() + 0.5 * crossing->from * outwards) ? 1 : 0;
  }
  if (found < kLeastShare * (count + 1)) return {};
  sidewalk.is_gap_drivable = 2 * drivable > found;
  return thinned(sidewalk);
}

}  // namespace forge
