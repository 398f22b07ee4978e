#include "collision_forge/ros/markers/marker_list.h"

#include <algorithm>
#include <cmath>

#include "collision_forge/ros/messages/conversions.h"

namespace forge {

namespace {

using visualization_msgs::Marker;

constexpr double kSlabThickness = 0.02;  // m

geometry_msgs::Point toPointMessage(const Vector2& point, double z) {
  geometry_msgs::Point message;
  message.x = point.x();
  message.y = point.y();
  message.z = z;
  return message;
}

geometry_msgs::Vector3 scale(double x, double y, double z) {
  geometry_msgs::Vector3 message;
  message.x = x;
  message.y = y;
  message.z = z;
  return message;
}

std::vector<Vector2> nose(const OrientedBox& box) {
  const auto point = [&box](double forward, double left) {
    const Pose2 local{forward * box.size.length, left * box.size.width, 0.0};
    return compose(box.center, local).position();
  };
  return {point(0.44, 0.0), point(0.2, 0.34), point(0.2, -0.34)};
}

bool isDrawable(const OrientedBox& box) {
  const BoxSize& size = box.size;
  return box.center.isFinite() && std::isfinite(size.length * size.width) && size.length > 0 &&
         size.width > 0;
}

}  // namespace

MarkerList::MarkerList(const std_msgs::Header& header) : header_(header) {
  add("", Marker::CUBE, {}).action = Marker::DELETEALL;
}

Marker& MarkerList::add(const std::string& name_space, std::int32_t type,
                        const colors::MarkerColor& color) {
  Marker marker;
  marker.header = header_;
  marker.ns = name_space;
  marker.id = static_cast<std::int32_t>(markers_.markers.size());
  marker.type = type;
  marker.action = Marker::ADD;
  marker.pose.orientation.w = 1.0;
  marker.color = colors::toMessage(color);
  markers_.markers.push_back(marker);
  return markers_.markers.back();
}

void MarkerList::addCuboid(const std::string& name_space, const OrientedBox& box, double bottom,
                           double top, const colors::MarkerColor& color) {
  Marker& marker = add(name_space, Marker::CUBE, color);
  marker.pose = toPoseMessage(box.center);
  marker.pose.position.z = (bottom + top) / 2;
  marker.scale = scale(box.size.length, box.size.width, top - bottom);
}

void MarkerList::addBox(const std::string& name_space, const OrientedBox& box, double height,
                        const colors::MarkerColor& color) {
  if (!isDrawable(box)) return;
  addCuboid(name_space, box, 0.0, height, color);
  addTriangles(name_space + "_heading", nose(box), height + kSlabThickness, colors::kNose);
}

void MarkerList::addSlab(const std::string& name_space, const OrientedBox& box, double z,
                         const colors::MarkerColor& color) {
  if (!isDrawable(box)) return;
  addCuboid(name_space, box, z, z + kSlabThickness, color);
}

void MarkerList::addDisc(const std::string& name_space, const Vector2& center, double diameter,
                         double z, const colors::MarkerColor& color) {
  if (!center.allFinite()) return;
  Marker& marker = add(name_space, Marker::CYLINDER, color);
  marker.pose.position = toPointMessage(center, z);
  marker.scale = scale(diameter, diameter, kSlabThickness);
}

void MarkerList::addText(const std::string& name_space, const std::string& text,
                         const Vector2& center, double letter_height, double z,
                         const colors::MarkerColor& color) {
  if (text.empty() || !center.allFinite()) return;
  Marker& marker = add(name_space, Marker::TEXT_VIEW_FACING, color);
  marker.text = text;
  marker.pose.position = toPointMessage(center, z);
  marker.scale = scale(0.0, 0.0, letter_height);
}

void MarkerList::addGroups(const std::string& name_space, std::int32_t type,
                           std::ptrdiff_t group_size, const std::vector<Vector2>& points, double z,
                           const geometry_msgs::Vector3& scale, const colors::MarkerColor& color) {
  std::vector<geometry_msgs::Point> finite;
  finite.reserve(points.size());
  for (auto group = points.begin(); group != points.end(); group += group_size) {
    const bool is_finite = std::all_of(group, group + group_size,
                                       [](const Vector2& point) { return point.allFinite(); });
    if (!is_finite) continue;
    for (auto point = group; point != group + group_size; ++point) {
      finite.push_back(toPointMessage(*point, z));
    }
  }
  if (finite.empty()) return;
  Marker& marker = add(name_space, type, color);
  marker.scale = scale;
  marker.points = std::move(finite);
}

void MarkerList::addLines(const std::string& name_space, const std::vector<Vector2>& points,
                          double width, double z, const colors::MarkerColor& color) {
  addGroups(name_space, Marker::LINE_LIST, 2, points, z, scale(width, 0.0, 0.0), color);
}

void MarkerList::addTriangles(const std::string& name_space, const std::vector<Vector2>& points,
                              double z, const colors::MarkerColor& color) {
  addGroups(name_space, Marker::TRIANGLE_LIST, 3, points, z, scale(1.0, 1.0, 1.0), color);
}

void appendPolyline(const std::vector<Vector2>& polyline, std::vector<Vector2>& lines) {
  for (std::size_t i = 1; i < polyline.size(); ++i) {
    lines.insert(lines.end(), {polyline[i - 1], polyline[i]});
  }
}

void appendOutline(const OrientedBox& box, std::vector<Vector2>& lines) {
  const auto ring = corners(box);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    lines.insert(lines.end(), {ring[i], ring[(i + 1) % ring.size()]});
  }
}

}  // namespace forge
