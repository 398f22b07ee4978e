#include "collision_forge/io/drawing/box_painter.h"

#include <algorithm>
#include <cmath>

namespace forge {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr Color kWedgeColor = {1.0, 1.0, 1.0};
constexpr double kWedgeOpacity = 0.75;
constexpr double kMinDotRadius = 2.5;  // pixels

Color darker(const Color& color) { return {0.6 * color.red, 0.6 * color.green, 0.6 * color.blue}; }

/// The wedge is within the front third, so that the middle of the box keeps the body's colour.
void paintWedge(Canvas& canvas, const Viewport& viewport, const OrientedBox& box) {
  const auto pixel = [&](double forward, double left) {
    const Pose2 local{forward * box.size.length, left * box.size.width, 0.0};
    return viewport.toPixel(compose(box.center, local).position());
  };
  canvas.fill({{pixel(0.44, 0.0), pixel(0.2, 0.34), pixel(0.2, -0.34)}}, kWedgeColor,
              kWedgeOpacity);
}

void paintBody(Canvas& canvas, const Viewport& viewport, const OrientedBox& box, const Color& color,
               double line_width) {
  const std::vector<Vector2> outline = boxPixels(viewport, box);
  canvas.fill({outline}, color);
  canvas.stroke(outline, {darker(color), line_width, 1.0, 0.0, true});
}

}  // namespace

std::vector<Vector2> boxPixels(const Viewport& viewport, const OrientedBox& box) {
  std::vector<Vector2> pixels;
  for (const Vector2& corner : corners(box)) pixels.push_back(viewport.toPixel(corner));
  return pixels;
}

void paintVehicle(Canvas& canvas, const Viewport& viewport, const OrientedBox& box,
                  const Color& color, double line_width) {
  paintBody(canvas, viewport, box, color, line_width);
  paintWedge(canvas, viewport, box);
}

void paintAgent(Canvas& canvas, const Viewport& viewport, const AgentBox& agent, const Color& color,
                double line_width) {
  switch (agent.agent_class) {
    case AgentClass::kPedestrian:
    case AgentClass::kChild:
    case AgentClass::kRunner:
    case AgentClass::kAnimal: {
      const double radius = 0.25 * (agent.box.size.length + agent.box.size.width);
      canvas.fillCircle(viewport.toPixel(agent.box.center.position()),
                        std::max(radius * viewport.pixelsPerMetre(), kMinDotRadius), darker(color));
      return;
    }
    case AgentClass::kStaticObject:
      paintBody(canvas, viewport, agent.box, color, line_width);
      return;
    default:
      paintVehicle(canvas, viewport, agent.box, color, line_width);
  }
}

void paintGhost(Canvas& canvas, const Viewport& viewport, const OrientedBox& box,
                const Color& color, double opacity, double line_width) {
  const std::vector<Vector2> outline = boxPixels(viewport, box);
  canvas.fill({outline}, color, opacity);
  canvas.stroke(outline, {color, line_width, std::min(1.0, 2 * opacity), 0.0, true});
}

void paintOutline(Canvas& canvas, const Viewport& viewport, const OrientedBox& box,
                  const Color& color, const Color& halo, double line_width) {
  const std::vector<Vector2> outline = boxPixels(viewport, box);
  canvas.stroke(outline, {halo, 2 * line_width, 0.8, 0.0, true});
  canvas.stroke(outline, {color, line_width, 1.0, 0.0, true});
}

void paintStar(Canvas& canvas, const Vector2& pixel, double radius, const Color& color,
               const Color& rim, double line_width) {
  constexpr int kRays = 8;
  std::vector<Vector2> outline;
  for (int i = 0; i < 2 * kRays; ++i) {
    const double reach = i % 2 == 0 ? radius : 0.5 * radius;
    const double angle = kPi * i / kRays;
    outline.push_back(pixel + reach * Vector2(std::sin(angle), -std::cos(angle)));
  }
  canvas.fill({outline}, color);
  canvas.stroke(outline, {rim, line_width, 1.0, 0.0, true});
}

}  // namespace forge
