#include "collision_forge/ros/messages/conversions.h"

#include <cmath>

#include "collision_forge/ros/messages/field_values.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {
namespace {

/// Corners of polygons are float32: relative to an origin within 6 km their error is below 1 mm.
/// A multiple of this power of two makes the subtraction exact, and is zero for most local maps.
constexpr double kOriginGrid = 8192.0;  // m

Vector2 originOf(const LaneMap& map) {
  Vector2 near = Vector2::Zero();
  for (const Lane& lane : map.lanes) {
    if (lane.centerline.empty()) continue;
    near = lane.centerline.front().position();
    break;
  }
  return {kOriginGrid * std::round(near.x() / kOriginGrid),
          kOriginGrid * std::round(near.y() / kOriginGrid)};
}

geometry_msgs::Polygon toPolygonMessage(const std::vector<Vector2>& ring, const Vector2& origin) {
  geometry_msgs::Polygon message;
  for (const Vector2& point : ring) {
    geometry_msgs::Point32 corner;
    corner.x = static_cast<float>(point.x() - origin.x());
    corner.y = static_cast<float>(point.y() - origin.y());
    message.points.push_back(corner);
  }
  return message;
}

std::vector<Vector2> fromMessage(const geometry_msgs::Polygon& message, const Vector2& origin) {
  std::vector<Vector2> ring;
  for (const auto& point : message.points) ring.push_back(origin + Vector2(point.x, point.y));
  return ring;
}

Lane fromMessage(const collision_forge::Lane& message, const Vector2& origin) {
  Lane lane;
  lane.id = message.id;
  lane.is_connector = message.is_connector;
  lane.is_intersection = message.is_intersection;
  for (const auto& pose : message.centerline) lane.centerline.push_back(forge::fromMessage(pose));
  lane.polygon = fromMessage(message.polygon, origin);
  lane.incoming = message.incoming;
  lane.outgoing = message.outgoing;
  if (message.speed_limit > 0.0) lane.speed_limit = message.speed_limit;
  return lane;
}

collision_forge::Lane toMessage(const Lane& lane, const Vector2& origin) {
  collision_forge::Lane message;
  message.id = lane.id;
  message.is_connector = lane.is_connector;
  message.is_intersection = lane.is_intersection;
  for (const Pose2& pose : lane.centerline) message.centerline.push_back(toPose2dMessage(pose));
  message.polygon = toPolygonMessage(lane.polygon, origin);
  message.incoming = lane.incoming;
  message.outgoing = lane.outgoing;
  message.speed_limit = lane.speed_limit.value_or(0.0);
  return message;
}

Polygon fromMessage(const collision_forge::PolygonWithHoles& message, const Vector2& origin) {
  Polygon polygon{fromMessage(message.exterior, origin), {}};
  for (const auto& hole : message.holes) polygon.holes.push_back(fromMessage(hole, origin));
  return polygon;
}

collision_forge::PolygonWithHoles toMessage(const Polygon& polygon, const Vector2& origin) {
  collision_forge::PolygonWithHoles message;
  message.exterior = toPolygonMessage(polygon.exterior, origin);
  for (const auto& hole : polygon.holes) message.holes.push_back(toPolygonMessage(hole, origin));
  return message;
}

MapFeature fromMessage(const collision_forge::MapFeature& message, const Vector2& origin) {
  return {enumOf(message.kind, FeatureKind::kBikeLane, "map feature: kind"),
          fromMessage(message.points, origin)};
}

collision_forge::MapFeature toMessage(const MapFeature& feature, const Vector2& origin) {
  collision_forge::MapFeature message;
  message.kind = static_cast<std::uint8_t>(feature.kind);
  message.points = toPolygonMessage(feature.points, origin);
  return message;
}

}  // namespace

LaneMap fromMessage(const collision_forge::LaneMap& message) {
  LaneMap map;
  map.location = message.location;
  map.driving_side = message.driving_side == collision_forge::LaneMap::DRIVE_LEFT
                         ? DrivingSide::kLeft
                         : DrivingSide::kRight;
  const Vector2 origin(message.origin.x, message.origin.y);
  for (const auto& lane : message.lanes) map.lanes.push_back(fromMessage(lane, origin));
  for (const auto& area : message.drivable_area) {
    map.drivable_area.push_back(fromMessage(area, origin));
  }
  for (const auto& walkway : message.walkways) map.walkways.push_back(fromMessage(walkway, origin));
  for (const auto& feature : message.features) {
    map.features.push_back(fromMessage(feature, origin));
  }
  return map;
}

collision_forge::LaneMap toMessage(const LaneMap& map, const ros::Time& stamp) {
  collision_forge::LaneMap message;
  message.header.frame_id = names::kMapFrame;
  message.header.stamp = stamp;
  message.location = map.location;
  message.driving_side = map.driving_side == DrivingSide::kLeft
                             ? collision_forge::LaneMap::DRIVE_LEFT
                             : collision_forge::LaneMap::DRIVE_RIGHT;
  const Vector2 origin = originOf(map);
  message.origin.x = origin.x();
  message.origin.y = origin.y();
  for (const Lane& lane : map.lanes) message.lanes.push_back(toMessage(lane, origin));
  for (const Polygon& area : map.drivable_area) {
    message.drivable_area.push_back(toMessage(area, origin));
  }
  for (const Polygon& walkway : map.walkways)
    message.walkways.push_back(toMessage(walkway, origin));
  for (const MapFeature& feature : map.features) {
    message.features.push_back(toMessage(feature, origin));
  }
  return message;
}

std::vector<TrafficLight> fromMessage(const collision_forge::TrafficLightArray& message) {
  std::vector<TrafficLight> lights;
  for (const auto& light : message.lights) {
    lights.push_back({light.lane,
                      {light.stop_point.x, light.stop_point.y},
                      {{message.header.stamp.toSec(), enumOf(light.color, LightColor::kGreen,
                                                             "light " + light.lane + ": color")}}});
  }
  return lights;
}

collision_forge::TrafficLightArray toMessage(const std::vector<TrafficLight>& lights,
                                             const ros::Time& stamp) {
  collision_forge::TrafficLightArray message;
  message.header.frame_id = names::kMapFrame;
  message.header.stamp = stamp;
  for (const TrafficLight& light : lights) {
    collision_forge::TrafficLight& written = message.lights.emplace_back();
    written.lane = light.lane;
    written.stop_point.x = light.stop_point.x();
    written.stop_point.y = light.stop_point.y();
    written.color = static_cast<std::uint8_t>(colorAt(light, stamp.toSec()));
  }
  return message;
}

}  // namespace forge
