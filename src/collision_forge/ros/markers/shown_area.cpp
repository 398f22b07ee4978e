#include "collision_forge/ros/markers/shown_area.h"

#include <algorithm>

namespace forge {
namespace {

constexpr double kMargin = 9.0;         // m between a box and the edge, for words beside the box
constexpr double kWidthToHeight = 1.4;  // of an area around one place
constexpr double kLeastScale = 0.6;     // of letters
constexpr double kMostScale = 3.0;

}  // namespace

ShownArea areaAround(const std::vector<OrientedBox>& boxes, double shortest_width) {
  ShownArea area{boxes.front().center.position(), boxes.front().center.position()};
  for (const OrientedBox& box : boxes) {
    for (const Vector2& corner : corners(box)) {
      area.lowest = area.lowest.cwiseMin(corner);
      area.highest = area.highest.cwiseMax(corner);
    }
  }
  const Vector2 margin(kMargin, kMargin);
  const Vector2 shortest(shortest_width, shortest_width / kWidthToHeight);
  const Vector2 half = (area.size() / 2.0 + margin).cwiseMax(shortest / 2.0);
  const Vector2 middle = area.middle();
  return {middle - half, middle + half};
}

double letterScale(const ShownArea& area) {
  const double width = std::max(area.size().x(), kWidthToHeight * area.size().y());
  return std::clamp(width / kUsualWidth, kLeastScale, kMostScale);
}

geometry_msgs::PolygonStamped toMessage(const ShownArea& area, const std_msgs::Header& header) {
  geometry_msgs::PolygonStamped message;
  message.header = header;
  for (const Vector2& corner : {area.lowest, Vector2(area.highest.x(), area.lowest.y()),
                                area.highest, Vector2(area.lowest.x(), area.highest.y())}) {
    geometry_msgs::Point32 point;
    point.x = static_cast<float>(corner.x());
    point.y = static_cast<float>(corner.y());
    message.polygon.points.push_back(point);
  }
  return message;
}

}  // namespace forge
