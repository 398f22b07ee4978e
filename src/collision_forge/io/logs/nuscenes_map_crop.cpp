#include <Eigen/Geometry>
#include <algorithm>
#include <unordered_set>

#include "collision_forge/io/logs/nuscenes_map.h"

namespace forge {
namespace {

using Box = Eigen::AlignedBox2d;

double squaredDistanceToSegment(const Vector2& point, const Vector2& a, const Vector2& b) {
  const Vector2 along = b - a;
  const double length = along.squaredNorm();
  const double ratio = length > 0.0 ? (point - a).dot(along) / length : 0.0;
  return (point - a - std::clamp(ratio, 0.0, 1.0) * along).squaredNorm();
}

/// Returns true if a point is within `radius` of the line through `shape`; closes rings first.
bool isNear(std::vector<Vector2> shape, bool is_ring, const std::vector<Vector2>& points,
            double radius) {
  if (shape.empty()) return false;
  if (is_ring) shape.push_back(shape.front());
  Box box;
  for (const Vector2& corner : shape) box.extend(corner);
  const double squared_radius = radius * radius;
  for (const Vector2& point : points) {
    if (box.squaredExteriorDistance(point) > squared_radius) continue;
    if ((shape.front() - point).squaredNorm() <= squared_radius) return true;
    for (std::size_t i = 1; i < shape.size(); ++i) {
      if (squaredDistanceToSegment(point, shape[i - 1], shape[i]) <= squared_radius) return true;
    }
  }
  return false;
}

bool isNear(const Polygon& polygon, const std::vector<Vector2>& points, double radius) {
  const auto is_inside = [&](const Vector2& point) { return contains(polygon, point); };
  return isNear(polygon.exterior, true, points, radius) ||
         std::any_of(points.begin(), points.end(), is_inside);
}

bool isNear(const Lane& lane, const std::vector<Vector2>& points, double radius) {
  std::vector<Vector2> line;
  for (const Pose2& pose : lane.centerline) line.push_back(pose.position());
  return isNear(line, false, points, radius) || isNear({lane.polygon, {}}, points, radius);
}

}  // namespace

LaneMap cropped(const LaneMap& map, const std::vector<Vector2>& points, double radius) {
  LaneMap crop;
  crop.location = map.location;
  crop.driving_side = map.driving_side;
  std::unordered_set<std::string> kept;
  for (const Lane& lane : map.lanes) {
    if (!isNear(lane, points, radius)) continue;
    crop.lanes.push_back(lane);
    kept.insert(lane.id);
  }
  const auto is_gone = [&](const std::string& id) { return kept.count(id) == 0; };
  for (Lane& lane : crop.lanes) {
    for (std::vector<std::string>* ids : {&lane.incoming, &lane.outgoing}) {
      ids->erase(std::remove_if(ids->begin(), ids->end(), is_gone), ids->end());
    }
  }
  for (const Polygon& polygon : map.drivable_area) {
    if (isNear(polygon, points, radius)) crop.drivable_area.push_back(polygon);
  }
  for (const Polygon& polygon : map.walkways) {
    if (isNear(polygon, points, radius)) crop.walkways.push_back(polygon);
  }
  for (const MapFeature& feature : map.features) {
    if (isNear(feature.points, !isOpenLine(feature.kind), points, radius)) {
      crop.features.push_back(feature);
    }
  }
  return crop;
}

}  // namespace forge
