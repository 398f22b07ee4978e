#include "collision_forge/io/export/common_road_lanelets.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "collision_forge/base/geometry/polyline.h"
#include "collision_forge/io/export/linked_lanes.h"
#include "collision_forge/io/export/road_course.h"

namespace forge {
namespace {

constexpr double kSamePoint = 1e-3;  // m; closer points of a centreline are merged
constexpr double kLargestBendShare =
    0.9;  // largest offset of an inner bound, share of the bend's radius
constexpr double kBesideTolerance = 0.25;  // share of the lane's width
constexpr double kBesideHeading = 0.2;     // rad

std::vector<Pose2> distinctPoses(const std::vector<Pose2>& poses) {
  std::vector<Pose2> distinct;
  for (const Pose2& pose : poses) {
    if (distinct.empty() || (pose.position() - distinct.back().position()).norm() > kSamePoint) {
      distinct.push_back(pose);
    }
  }
  return distinct;
}

double lengthOf(const std::vector<Pose2>& poses) {
  double length = 0.0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    length += (poses[i].position() - poses[i - 1].position()).norm();
  }
  return length;
}

/// Returns true if the pose `left` is next to `right`, `distance` to its left, with equal heading.
bool isBeside(const Pose2& left, const Pose2& right, double distance) {
  if (std::abs(angleBetween(left.yaw, right.yaw)) > kBesideHeading) return false;
  const Pose2 between = interpolate(left, right, 0.5);
  const Pose2 seen = relativeTo({right.x, right.y, between.yaw}, left);
  const double tolerance = kBesideTolerance * distance;
  return std::abs(seen.x) <= tolerance && std::abs(seen.y - distance) <= tolerance;
}

Pose2 middleOf(const std::vector<Pose2>& poses) {
  std::vector<Vector2> points;
  for (const Pose2& pose : poses) points.push_back(pose.position());
  const Polyline line(points);
  return line.poseAt(0.5 * line.length());
}

/// Returns true if the lanelets are side by side from start to end.
bool areBeside(const Lanelet& left, const Lanelet& right) {
  const double distance = 0.5 * (left.width + right.width);
  return isBeside(left.middle.front(), right.middle.front(), distance) &&
         isBeside(left.middle.back(), right.middle.back(), distance) &&
         isBeside(middleOf(left.middle), middleOf(right.middle), distance);
}

/// Sets adjacent lanelets; none on a side with two candidates, for instance where lanes overlap.
void findNeighbours(std::vector<Lanelet>& lanelets) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;  // left, right
  std::map<std::size_t, int> lefts;                        // number of candidates by lanelet
  std::map<std::size_t, int> rights;
  for (std::size_t left = 0; left < lanelets.size(); ++left) {
    for (std::size_t right = 0; right < lanelets.size(); ++right) {
      if (left == right || !areBeside(lanelets[left], lanelets[right])) continue;
      pairs.emplace_back(left, right);
      ++lefts[right];
      ++rights[left];
    }
  }
  for (const auto& [left, right] : pairs) {
    if (lefts[right] > 1 || rights[left] > 1) continue;
    lanelets[left].right = lanelets[right].number;
    lanelets[right].left = lanelets[left].number;
  }
}

}  // namespace

std::vector<Lanelet> laneletsOf(const LaneMap& map, const std::vector<Lane>& bike_lanes,
                                double lane_width, int first) {
  std::vector<Lanelet> lanelets;
  for (const Lane& lane : map.lanes) {
    Lanelet lanelet{first, &lane, distinctPoses(lane.centerline)};
    if (lanelet.middle.size() < 2) continue;
    lanelet.width = widthOf(lane, lengthOf(lanelet.middle), lane_width);
    lanelets.push_back(std::move(lanelet));
    ++first;
  }
  findNeighbours(lanelets);
  for (const Lane& lane : bike_lanes) {
    Lanelet lanelet{first, &lane, distinctPoses(lane.centerline)};
    if (lanelet.middle.size() < 2) continue;
    lanelet.width = kBikeLaneWidth;
    lanelet.is_for_bikes = true;
    lanelets.push_back(std::move(lanelet));
    ++first;
  }
  return lanelets;
}

std::vector<Vector2> boundOf(const Lanelet& lanelet, double side) {
  const std::vector<Pose2>& middle = lanelet.middle;
  std::vector<double> offsets(middle.size(), 0.5 * lanelet.width);
  for (std::size_t i = 1; i < middle.size(); ++i) {
    const double turn = std::abs(angleBetween(middle[i - 1].yaw, middle[i].yaw));
    if (turn == 0.0) continue;
    const double length = (middle[i].position() - middle[i - 1].position()).norm();
    const double most = kLargestBendShare * length / turn;
    offsets[i - 1] = std::min(offsets[i - 1], most);
    offsets[i] = std::min(offsets[i], most);
  }
  std::vector<Vector2> bound;
  for (std::size_t i = 0; i < middle.size(); ++i) {
    bound.push_back(compose(middle[i], {0.0, side * offsets[i], 0.0}).position());
  }
  return bound;
}

}  // namespace forge
