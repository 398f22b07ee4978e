#include "collision_forge/io/drawing/map_painter.h"

#include <algorithm>

namespace forge {

namespace {

constexpr double kArrowSpacing = 18.0;  // m along a centreline
constexpr double kArrowLength = 1.8;    // m
constexpr double kArrowWidth = 1.3;     // m

std::vector<Vector2> toPixels(const Viewport& viewport, const std::vector<Vector2>& points) {
  std::vector<Vector2> pixels;
  pixels.reserve(points.size());
  for (const Vector2& point : points) pixels.push_back(viewport.toPixel(point));
  return pixels;
}

void paintArea(Canvas& canvas, const Viewport& viewport, const std::vector<Polygon>& area,
               const Color& color) {
  for (const Polygon& polygon : area) {
    std::vector<std::vector<Vector2>> rings = {toPixels(viewport, polygon.exterior)};
    for (const std::vector<Vector2>& hole : polygon.holes) {
      rings.push_back(toPixels(viewport, hole));
    }
    canvas.fill(rings, color);
    // Closes the hairline that antialiasing leaves between neighbouring polygons.
    canvas.stroke(rings.front(), {color, 1.0, 1.0, 0.0, true});
  }
}

void paintArrowHead(Canvas& canvas, const Viewport& viewport, const Pose2& pose,
                    const Color& color) {
  const auto pixel = [&](double forward, double left) {
    return viewport.toPixel(compose(pose, {forward, left, 0.0}).position());
  };
  canvas.fill({{pixel(kArrowLength / 2, 0), pixel(-kArrowLength / 2, kArrowWidth / 2),
                pixel(-kArrowLength / 4, 0), pixel(-kArrowLength / 2, -kArrowWidth / 2)}},
              color);
}

/// Paints an arrow head every kArrowSpacing metres, the first after half of it; a short lane has
/// one in its middle.
void paintArrowHeads(Canvas& canvas, const Viewport& viewport, const Lane& lane,
                     const Color& color) {
  double length = 0.0;
  for (std::size_t i = 1; i < lane.centerline.size(); ++i) {
    length += (lane.centerline[i].position() - lane.centerline[i - 1].position()).norm();
  }
  double next = std::min(kArrowSpacing, length) / 2;
  double travelled = 0.0;
  for (std::size_t i = 1; i < lane.centerline.size(); ++i) {
    const Pose2& from = lane.centerline[i - 1];
    const Pose2& to = lane.centerline[i];
    const double step = (to.position() - from.position()).norm();
    for (; step > 0 && next < travelled + step; next += kArrowSpacing) {
      const Pose2 pose = interpolate(from, to, (next - travelled) / step);
      if (viewport.area().contains(viewport.toPixel(pose.position()))) {
        paintArrowHead(canvas, viewport, pose, color);
      }
    }
    travelled += step;
  }
}

void paintLane(Canvas& canvas, const Viewport& viewport, const Lane& lane,
               const DrawingOptions& options, double line_width) {
  const Color& color = lane.is_connector ? options.connector_color : options.lane_color;
  std::vector<Vector2> line;
  line.reserve(lane.centerline.size());
  for (const Pose2& pose : lane.centerline) line.push_back(viewport.toPixel(pose.position()));
  canvas.stroke(line, {color, line_width, 1.0, lane.is_connector ? 0.0 : 6 * line_width, false});
  paintArrowHeads(canvas, viewport, lane, color);
}

}  // namespace

void paintMap(Canvas& canvas, const Viewport& viewport, const LaneMap& map,
              const DrawingOptions& options, double line_width) {
  paintArea(canvas, viewport, map.walkways, options.walkway_color);
  paintArea(canvas, viewport, map.drivable_area, options.drivable_color);
  for (const MapFeature& feature : map.features) {
    if (isRoadEdge(feature.kind)) {
      canvas.stroke(toPixels(viewport, feature.points),
                    {options.road_edge_color, line_width, 1.0, 0.0, false});
    } else if (isPaintedLine(feature.kind)) {
      canvas.stroke(toPixels(viewport, feature.points),
                    {options.painted_color, line_width, 1.0, 0.0, false});
    } else if (!isOpenLine(feature.kind) && feature.kind != FeatureKind::kDriveway) {
      canvas.fill({toPixels(viewport, feature.points)}, options.painted_color);
    }
  }
  for (const Lane& lane : map.lanes) {
    if (lane.is_connector || lane.polygon.empty()) continue;
    canvas.stroke(toPixels(viewport, lane.polygon),
                  {options.background_color, line_width, 1.0, 0.0, true});
  }
  for (const bool connectors : {true, false}) {
    for (const Lane& lane : map.lanes) {
      if (lane.is_connector == connectors) {
        paintLane(canvas, viewport, lane, options, line_width);
      }
    }
  }
}

}  // namespace forge
