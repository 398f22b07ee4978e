#include "collision_forge/drawing/close_up_inset.h"

#include <algorithm>
#include <limits>

namespace forge {
namespace {

constexpr double kNoGhosts = std::numeric_limits<double>::infinity();

Viewport closeUpOf(const ScenePainter& scene, double side, double extent) {
  return {{0.0, 0.0, side, side}, scene.motion().contactPoint(), side / extent, scene.rightwards()};
}

}  // namespace

CloseUpInset::CloseUpInset(const ScenePainter& scene, const PixelRect& area,
                           const DrawingOptions& options)
    : scene_(scene),
      area_(area),
      frame_{options.text_color, 1.0, 1.0, 0.0, true},
      viewport_(closeUpOf(scene, area.width, options.close_up_extent)),
      ground_(static_cast<int>(area.width), static_cast<int>(area.height),
              options.background_color) {
  Canvas canvas(ground_);
  scene.paintGround(canvas, viewport_);
}

void CloseUpInset::paint(Canvas& canvas, double time) const {
  Image image(ground_);
  Canvas near(image);
  scene_.paint(near, viewport_, time, kNoGhosts);
  canvas.image({area_.x, area_.y}, image);
  canvas.stroke(edgeOf(area_), frame_);
}

PixelRect freeCorner(const PixelRect& area, double side, double gap,
                     const std::vector<Vector2>& points) {
  const double left = area.x + gap;
  const double right = area.x + area.width - gap - side;
  const double top = area.y + gap;
  const double bottom = area.y + area.height - gap - side;
  const std::vector<PixelRect> corners = {{right, top, side, side},
                                          {left, top, side, side},
                                          {right, bottom, side, side},
                                          {left, bottom, side, side}};
  const auto covered = [&points](const PixelRect& corner) {
    return std::count_if(points.begin(), points.end(),
                         [&corner](const Vector2& point) { return corner.contains(point); });
  };
  return *std::min_element(
      corners.begin(), corners.end(),
      [&](const PixelRect& a, const PixelRect& b) { return covered(a) < covered(b); });
}

}  // namespace forge
