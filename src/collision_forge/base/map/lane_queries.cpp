#include "collision_forge/base/map/lane_queries.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace forge {
namespace {

constexpr double kSampleSpacing = 0.25;       // m, largest distance between samples of a box
constexpr double kJointGap = 0.2;             // metres, see appendStretch
constexpr double kMinPathLength = 1.0;        // metres
constexpr double kSameCosine = 1e-9;          // headings this similar count as equal turns
constexpr std::size_t kMaxLanesAhead = 1000;  // ends loops of very short lanes

Eigen::AlignedBox2d boundsOf(const std::vector<Vector2>& points) {
  Eigen::AlignedBox2d bounds;
  for (const Vector2& point : points) {
    bounds.extend(point);
  }
  return bounds;
}

std::optional<Polyline> centerlineOf(const Lane& lane) {
  std::vector<Vector2> points;
  for (const Pose2& pose : lane.centerline) {
    points.push_back(pose.position());
  }
  const bool distinct = std::any_of(points.begin(), points.end(), [&](const Vector2& point) {
    return !((point - points.front()).norm() < 1e-3);
  });
  return distinct ? std::make_optional<Polyline>(points) : std::nullopt;
}

std::vector<std::optional<Polyline>> centerlinesOf(const LaneMap& map) {
  std::vector<std::optional<Polyline>> centerlines;
  centerlines.reserve(map.lanes.size());
  for (const Lane& lane : map.lanes) centerlines.push_back(centerlineOf(lane));
  return centerlines;
}

bool isWithin(const Eigen::AlignedBox2d& bounds, const Vector2& point, double distance) {
  return !bounds.isEmpty() && bounds.squaredExteriorDistance(point) <= distance * distance;
}

// Appends the part of a line between two arc lengths to a path. Merges points closer together than
// kJointGap: where lanes do not join exactly, the short step between them has no useful heading.
void appendStretch(const Polyline& line, double from, double to, std::vector<Vector2>& path) {
  for (std::size_t i = 0; i < line.points().size(); ++i) {
    const double arc_length = line.arcLengths()[i];
    const Vector2& point = line.points()[i];
    if (arc_length > from && arc_length < to && (point - path.back()).norm() > kJointGap) {
      path.push_back(point);
    }
  }
  const Vector2 end = line.poseAt(to).position();
  if ((end - path.back()).norm() > kJointGap) {
    path.push_back(end);
  } else if (path.size() > 1) {
    path.back() = end;
  }
}

LaneMap reverseLanes(LaneMap map) {
  map.driving_side =
      map.driving_side == DrivingSide::kRight ? DrivingSide::kLeft : DrivingSide::kRight;
  for (Lane& lane : map.lanes) {
    std::reverse(lane.centerline.begin(), lane.centerline.end());
    for (Pose2& pose : lane.centerline) pose.yaw = wrapAngle(pose.yaw + M_PI);
    std::swap(lane.incoming, lane.outgoing);
  }
  return map;
}

// Extends a path that is too short to have a heading, straight on.
void lengthenToMinimum(LanePath& path) {
  if (path.length < kMinPathLength || path.points.size() < 2) {
    path.points.push_back(path.end.position() + kMinPathLength * path.end.heading());
  }
}

// The samples of a box: the centres of its cells, row by row along its length.
class BoxSamples {
 public:
  explicit BoxSamples(const OrientedBox& box)
      : center_(box.center.position()),
        columns_(box.size.length, box.center.heading()),
        rows_(box.size.width, box.center.heading().unitOrthogonal()),
        covered_(columns_.count * rows_.count, false) {}

  void cover(const Polygon& polygon) {
    std::vector<bool> inside = insideRing(polygon.exterior);
    for (const std::vector<Vector2>& hole : polygon.holes) {
      const std::vector<bool> in_hole = insideRing(hole);
      for (std::size_t i = 0; i < inside.size(); ++i) {
        inside[i] = inside[i] && !in_hole[i];
      }
    }
    for (std::size_t i = 0; i < inside.size(); ++i) {
      covered_[i] = covered_[i] || inside[i];
    }
  }

  double uncoveredShare() const {
    const auto uncovered = std::count(covered_.begin(), covered_.end(), false);
    return static_cast<double>(uncovered) / static_cast<double>(covered_.size());
  }

 private:
  // Cells along one side of the box; coordinates count cells, integers are cell centres.
  struct Cells {
    Cells(double side, const Vector2& direction)
        : count(static_cast<std::size_t>(std::max(1.0, std::ceil(side / kSampleSpacing)))),
          axis(direction * (static_cast<double>(count) / std::max(side, 1e-9))),
          middle(0.5 * static_cast<double>(count) - 0.5) {}

    double coordinate(const Vector2& offset) const { return axis.dot(offset) + middle; }

    // Returns the index of the first cell at or after a coordinate, 0 to `count`.
    std::size_t firstFrom(double coordinate) const {
      return static_cast<std::size_t>(
          std::max(0.0, std::min(static_cast<double>(count), std::ceil(coordinate))));
    }

    std::size_t count;
    Vector2 axis;
    double middle;
  };

  // Even-odd rule for all samples at once: each edge that crosses a row flips the samples before
  // the crossing.
  std::vector<bool> insideRing(const std::vector<Vector2>& ring) const {
    std::vector<bool> inside(covered_.size(), false);
    if (ring.empty()) {
      return inside;
    }
    const double last_row = static_cast<double>(rows_.count - 1);
    Vector2 a = ring.back() - center_;
    double a_row = rows_.coordinate(a);
    for (const Vector2& point : ring) {
      const Vector2 b = point - center_;
      const double b_row = rows_.coordinate(b);
      if (std::max(a_row, b_row) > 0.0 && std::min(a_row, b_row) <= last_row) {
        flipBefore(a, b, inside);
      }
      a = b;
      a_row = b_row;
    }
    return inside;
  }

  void flipBefore(const Vector2& a, const Vector2& b, std::vector<bool>& inside) const {
    const double a_row = rows_.coordinate(a);
    const double b_row = rows_.coordinate(b);
    const std::size_t end_row = rows_.firstFrom(std::max(a_row, b_row));
    for (std::size_t row = rows_.firstFrom(std::min(a_row, b_row)); row < end_row; ++row) {
      const double ratio = (static_cast<double>(row) - a_row) / (b_row - a_row);
      const std::size_t end = columns_.firstFrom(columns_.coordinate(a + ratio * (b - a)));
      for (std::size_t i = row * columns_.count; i < row * columns_.count + end; ++i) {
        inside[i] = !inside[i];
      }
    }
  }

  Vector2 center_;
  Cells columns_;
  Cells rows_;
  std::vector<bool> covered_;
};

}  // namespace

LaneIndex::LaneIndex(std::shared_ptr<const LaneMap> map)
    : map_(map ? std::move(map) : throw std::invalid_argument("lane index needs a map")),
      drivable_(map_->drivable_area),
      walkways_(map_->walkways),
      centerlines_(centerlinesOf(*map_)),
      grid_(centerlines_) {
  std::unordered_map<std::string, std::size_t> index_of;
  for (std::size_t i = 0; i < map_->lanes.size(); ++i) {
    index_of.emplace(map_->lanes[i].id, i);
  }
  for (const std::optional<Polyline>& line : centerlines_) {
    lane_bounds_.push_back(line ? boundsOf(line->points()) : Eigen::AlignedBox2d());
  }
  for (const Lane& lane : map_->lanes) {
    successors_.emplace_back();
    for (const std::string& id : lane.outgoing) {
      const auto found = index_of.find(id);
      if (found != index_of.end()) {
        successors_.back().push_back(found->second);
      }
    }
  }
  for (const Polygon& polygon : map_->drivable_area) {
    drivable_bounds_.push_back(boundsOf(polygon.exterior));
  }
}

const LaneIndex& LaneIndex::reversed() const {
  std::call_once(reversed_->once, [&] {
    reversed_->index =
        std::make_unique<const LaneIndex>(std::make_shared<const LaneMap>(reverseLanes(*map_)));
  });
  return *reversed_->index;
}

std::vector<LaneMatch> LaneIndex::lanesNear(const Pose2& pose, double max_distance,
                                            double max_heading) const {
  std::vector<LaneMatch> matches;
  for (std::size_t i = 0; i < centerlines_.size(); ++i) {
    if (!isWithin(lane_bounds_[i], pose.position(), max_distance)) {
      continue;
    }
    const PolylineProjection projection = centerlines_[i]->project(pose.position());
    const double heading_error = angleBetween(projection.pose.yaw, pose.yaw);
    if (projection.distance <= max_distance && std::abs(heading_error) <= max_heading) {
      matches.push_back({i, projection, heading_error});
    }
  }
  const auto rank = [](const LaneMatch& match) {
    return std::make_tuple(std::round(match.projection.distance * 1e3),
                           std::abs(match.heading_error), match.lane);
  };
  std::sort(matches.begin(), matches.end(),
            [&](const LaneMatch& a, const LaneMatch& b) { return rank(a) < rank(b); });
  return matches;
}

std::vector<std::size_t> LaneIndex::lanesWithin(const Vector2& center, double radius) const {
  std::vector<std::pair<double, std::size_t>> found;
  for (std::size_t i = 0; i < centerlines_.size(); ++i) {
    if (!isWithin(lane_bounds_[i], center, radius)) {
      continue;
    }
    const double distance = centerlines_[i]->project(center).distance;
    if (distance <= radius) {
      found.emplace_back(distance, i);
    }
  }
  std::sort(found.begin(), found.end());
  std::vector<std::size_t> lanes;
  lanes.reserve(found.size());
  for (const auto& [distance, lane] : found) {
    lanes.push_back(lane);
  }
  return lanes;
}

Polyline LaneIndex::pathAhead(std::size_t lane, double arc_length, double distance) const {
  return Polyline(pathsAhead(lane, arc_length, distance, 1).front().points);
}

std::vector<LanePath> LaneIndex::pathsAhead(std::size_t lane, double arc_length, double distance,
                                            std::size_t max_paths) const {
  const Polyline& line = existingCenterline(lane);
  const double from = std::clamp(arc_length, 0.0, line.length());
  std::vector<LanePath> paths(1);
  paths.front().points = {line.poseAt(from).position()};
  extend(paths.front(), lane, from, distance);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    while (paths[i].length < distance && paths[i].lanes.size() < kMaxLanesAhead) {
      const std::size_t last = paths[i].lanes.back();
      const std::optional<std::size_t> straightest = straightestSuccessor(last);
      if (!straightest) {
        break;
      }
      for (const std::size_t other : successors_[last]) {
        if (other != *straightest && centerlines_[other] && paths.size() < max_paths) {
          paths.push_back(paths[i]);
          extend(paths.back(), other, 0.0, distance);
        }
      }
      extend(paths[i], *straightest, 0.0, distance);
    }
    lengthenToMinimum(paths[i]);
  }
  return paths;
}

// Extends a path along a lane, from an arc length on, until the path is `distance` long.
void LaneIndex::extend(LanePath& path, std::size_t lane, double from, double distance) const {
  const Polyline& line = *centerlines_[lane];
  const double to = std::min(line.length(), from + std::max(distance - path.length, 0.0));
  appendStretch(line, from, to, path.points);
  path.lanes.push_back(lane);
  path.length += to - from;
  path.end = line.poseAt(to);
}

std::optional<std::size_t> LaneIndex::straightestSuccessor(std::size_t lane) const {
  const Polyline& line = existingCenterline(lane);
  const Vector2 heading = line.poseAt(line.length()).heading();
  std::optional<std::size_t> best;
  double best_cosine = 0.0;
  for (const std::size_t successor : successors_[lane]) {
    if (!centerlines_[successor]) {
      continue;
    }
    // The smallest cosine along the lane corresponds to its largest difference of heading.
    double cosine = 1.0;
    const std::vector<Vector2>& points = centerlines_[successor]->points();
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      cosine = std::min(cosine, heading.dot((points[i + 1] - points[i]).normalized()));
    }
    if (!best || cosine > best_cosine + kSameCosine) {
      best = successor;
      best_cosine = cosine;
    }
  }
  return best;
}

std::optional<double> LaneIndex::offRoadShare(const OrientedBox& box) const {
  if (map_->drivable_area.empty()) {
    return std::nullopt;
  }
  Eigen::AlignedBox2d bounds;
  for (const Vector2& corner : corners(box)) {
    bounds.extend(corner);
  }
  BoxSamples samples(box);
  for (std::size_t i = 0; i < drivable_bounds_.size(); ++i) {
    if (drivable_bounds_[i].intersects(bounds)) {
      samples.cover(map_->drivable_area[i]);
    }
  }
  return samples.uncoveredShare();
}

const Polyline& LaneIndex::existingCenterline(std::size_t lane) const {
  if (lane >= centerlines_.size() || !centerlines_[lane]) {
    throw std::invalid_argument("lane " + std::to_string(lane) + " has no centreline");
  }
  return *centerlines_[lane];
}

}  // namespace forge
