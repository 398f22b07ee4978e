#include "collision_forge/io/export/open_drive_objects.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "collision_forge/io/export/xml.h"

namespace forge {
namespace {

// Own choice.
constexpr double kFarthest = 20.0;        // m from a reference line
constexpr double kLargestIsland = 300.0;  // m^2; larger holes of the drivable area are blocks
constexpr double kSmallestIsland = 1.0;   // m^2; smaller ones are seams between polygons
constexpr std::size_t kMostPoints = 16;   // of a large outline that are compared with each road
constexpr double kBoxSpacing = 2.0;       // m between the points of a road in its box
constexpr double kClosed = 0.5;           // m between the ends of a closed median

double areaOf(const std::vector<Vector2>& ring) {
  double twice = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector2 a = ring[i] - ring[0], b = ring[(i + 1) % ring.size()] - ring[0];
    twice += a.x() * b.y() - b.x() * a.y();
  }
  return std::abs(twice) / 2.0;
}

bool isIsland(const std::vector<Vector2>& ring) {
  const double area = areaOf(ring);
  return ring.size() > 2 && area >= kSmallestIsland && area <= kLargestIsland;
}

Vector2 middleOf(const std::vector<Vector2>& ring) {
  Vector2 middle = Vector2::Zero();
  for (const Vector2& point : ring) middle += point / static_cast<double>(ring.size());
  return middle;
}

/// Returns at most kMostPoints points of a ring, evenly chosen.
std::vector<Vector2> someOf(const std::vector<Vector2>& ring) {
  const std::size_t step = (ring.size() + kMostPoints - 1) / kMostPoints;
  std::vector<Vector2> some;
  for (std::size_t i = 0; i < ring.size(); i += step) some.push_back(ring[i]);
  return some;
}

}  // namespace

ObjectWriter::ObjectWriter(const LaneMap& map, const RoadNetwork& network) {
  for (const Road& road : network.roads) {
    Eigen::AlignedBox2d box(road.course.poseAt(road.course.length()).position());
    for (double at = 0.0; at < road.course.length(); at += kBoxSpacing) {
      box.extend(road.course.poseAt(at).position());
    }
    boxes_.push_back(box);
  }
  for (const MapFeature& feature : map.features) {
    if (feature.points.size() < 3) continue;
    if (feature.kind == FeatureKind::kCrosswalk) {
      place("crosswalk", "crosswalk", feature.points, network);
    } else if (feature.kind == FeatureKind::kMedian &&
               (feature.points.front() - feature.points.back()).norm() < kClosed &&
               isIsland(feature.points)) {
      place("trafficIsland", "island", {feature.points.begin(), feature.points.end() - 1}, network);
    }
  }
  for (const Polygon& walkway : map.walkways) {
    if (walkway.exterior.size() > 2) place("none", "walkway", walkway.exterior, network);
  }
  for (const Polygon& area : map.drivable_area) {
    for (const std::vector<Vector2>& hole : area.holes) {
      if (isIsland(hole)) place("trafficIsland", "island", hole, network);
    }
  }
}

void ObjectWriter::place(const char* type, const char* name, std::vector<Vector2> outline,
                         const RoadNetwork& network) {
  std::vector<Vector2> points = {middleOf(outline)};  // the middle suits small outlines
  if (areaOf(outline) > kLargestIsland) points = someOf(outline);
  std::optional<Object> nearest;
  for (std::size_t i = 0; i < network.roads.size(); ++i) {
    const Road& road = network.roads[i];
    for (const Vector2& point : points) {
      const double most = nearest ? std::abs(nearest->lateral) : kFarthest;
      if (boxes_[i].exteriorDistance(point) > most) continue;
      const double at = road.course.projection(point, road.course.roughProjection(point));
      if (!(at >= 0.0 && at <= road.course.length())) continue;
      const double lateral = relativeTo(road.course.poseAt(at), {point.x(), point.y(), 0.0}).y;
      if (nearest && std::abs(nearest->lateral) <= std::abs(lateral)) continue;
      nearest = Object{type, name, {}, road.id, at, lateral};
    }
  }
  if (!nearest || std::abs(nearest->lateral) > kFarthest) return;
  nearest->outline = std::move(outline);
  objects_.push_back(std::move(*nearest));
}

void ObjectWriter::addObjects(pugi::xml_node road_node, const Road& road) const {
  pugi::xml_node objects;
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    const Object& object = objects_[i];
    if (object.road != road.id) continue;
    if (!objects) objects = addElement(road_node, "objects");
    pugi::xml_node node = addElement(objects, "object",
                                     {{"type", object.type},
                                      {"name", object.name},
                                      {"id", std::to_string(i + 1)},
                                      {"s", xmlNumber(object.arc_length)},
                                      {"t", xmlNumber(object.lateral)},
                                      {"zOffset", "0"},
                                      {"hdg", "0"},
                                      {"orientation", "none"}});
    pugi::xml_node outline = addElement(addElement(node, "outlines"), "outline",
                                        {{"id", "0"}, {"outer", "true"}, {"closed", "true"}});
    const Pose2 origin = compose(road.course.poseAt(object.arc_length), {0.0, object.lateral, 0.0});
    for (const Vector2& point : object.outline) {
      const Pose2 corner = relativeTo(origin, {point.x(), point.y(), 0.0});
      addElement(
          outline, "cornerLocal",
          {{"u", xmlNumber(corner.x)}, {"v", xmlNumber(corner.y)}, {"z", "0"}, {"height", "0"}});
    }
  }
}

}  // namespace forge
