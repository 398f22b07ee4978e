#include "collision_forge/io/drawing/close_up_inset.h"

#include <algorithm>
#include <limits>

namespace forge {
namespace {

constexpr double kNoGhosts = std::numeric_limits<double>::infinity();

/// Returns a square of `side` pixels that shows `extent` metres around `center`.
Viewport closeUpOf(const ScenePainter& scene, const Vector2& center, double side, double extent) {
  return {{0.0, 0.0, side, side}, center, side / extent, scene.rightwards()};
}

Image groundOf(const ScenePainter& scene, const Viewport& viewport, const DrawingOptions& options) {
  const PixelRect& area = viewport.area();
  Image ground(static_cast<int>(area.width), static_cast<int>(area.height),
               options.background_color);
  Canvas canvas(ground);
  scene.paintGround(canvas, viewport);
  return ground;
}

}  // namespace

CloseUpInset::CloseUpInset(const ScenePainter& scene, const PixelRect& area,
                           const DrawingOptions& options)
    : scene_(scene),
      options_(options),
      area_(area),
      frame_{options.text_color, 1.0, 1.0, 0.0, true},
      ground_(groundOf(
          scene,
          closeUpOf(scene, scene.motion().contactPoint(), area.width, options.close_up_extent),
          options)) {}

void CloseUpInset::paint(Canvas& canvas, double time) const {
  const Vector2 center = scene_.motion().closeUpCenter(time);
  const Viewport viewport = closeUpOf(scene_, center, area_.width, options_.close_up_extent);
  const bool is_moved = center != scene_.motion().contactPoint();
  Image image(is_moved ? groundOf(scene_, viewport, options_) : ground_);
  Canvas near(image);
  scene_.paint(near, viewport, time, kNoGhosts);
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
