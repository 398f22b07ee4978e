#include "collision_forge/io/drawing/scenario_painter.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision_forge/io/drawing/box_painter.h"
#include "collision_forge/io/drawing/caption_painter.h"
#include "collision_forge/io/drawing/decimal_text.h"

namespace forge {

namespace {

constexpr double kTimeTolerance = 1e-6;  // s
constexpr double kNoGhosts = std::numeric_limits<double>::infinity();
constexpr double kMarginAside =
    1.5;  // factor on the margin above and below: shows more of the road
constexpr double kLeastMapHeight = 0.22;  // share of the map's width: leaves space for labels

Viewport closeUp(const PixelRect& area, const ScenePainter& scene, const Vector2& center,
                 double extent) {
  return {area, center, area.width / extent, scene.rightwards()};
}

}  // namespace

ScenarioPainter::ScenarioPainter(const ScenarioView& view, const DrawingOptions& options,
                                 const FigureSize& size, PictureKind kind)
    : view_(view),
      options_(options),
      size_(size),
      kind_(kind),
      scene_(view, options, size.font_size, kind),
      map_viewport_(fitMap(layoutFigure(size).map)),
      layout_(withMapHeight(layoutFigure(size), map_viewport_.area().height)),
      close_up_viewport_(closeUp(layout_.close_up, scene_, scene_.motion().contactPoint(),
                                 options.close_up_extent)),
      background_(
          size.width,
          size.height - static_cast<int>(layoutFigure(size).map.height - layout_.map.height),
          options.background_color) {
  paintBackground();
  placeLabels();
}

Viewport ScenarioPainter::fitMap(const PixelRect& area) const {
  std::vector<Vector2> points = scene_.shownCorners(scene_.trailsFrom());
  points.push_back(scene_.motion().contactPoint());
  const Viewport whole =
      fitViewport(area, points, options_.view_margin, options_.min_extent, scene_.rightwards());
  double reach = 0.0;  // largest distance of a point above or below the middle, pixels
  for (const Vector2& point : points) {
    reach = std::max(reach, area.center().y() - whole.toPixel(point).y());
  }
  const double margin = kMarginAside * options_.view_margin * whole.pixelsPerMetre();
  PixelRect cropped = area;
  cropped.height = std::clamp(std::ceil(2 * (reach + margin)),
                              std::min(kLeastMapHeight * area.width, area.height), area.height);
  return whole.movedTo(cropped);
}

void ScenarioPainter::paintBackground() {
  Canvas canvas(background_);
  for (const Viewport& viewport : {map_viewport_, close_up_viewport_}) {
    canvas.clip(viewport.area());
    scene_.paintGround(canvas, viewport);
    canvas.unclip();
  }
  const double font = size_.font_size;
  const PixelRect& map = layout_.map;
  const LineStyle rule{options_.lane_color, 1.0, 1.0, 0.0, false};
  canvas.stroke({{map.x, map.y}, {map.x + map.width, map.y}}, rule);
  canvas.stroke({{map.x, map.y + map.height}, {map.x + map.width, map.y + map.height}}, rule);
  paintHeader(canvas, layout_, size_, view_, options_);
  paintLegend(canvas, layout_, size_, view_, kind_, options_);
  paintReport(canvas, layout_, size_, view_, options_);
  canvas.text({layout_.close_up.x, layout_.legend.y + font}, "Close-up",
              {options_.text_color, font, true, TextAlign::kLeft});
}

void ScenarioPainter::placeLabels() {
  Canvas canvas(background_);
  LabelPlacer placer(layout_.map);
  const ScenarioMotion& motion = scene_.motion();
  const double key_time = motion.keyTime();
  for (const Vector2& corner : scene_.shownCorners(scene_.trailsFrom()))
    placer.avoid(map_viewport_.toPixel(corner));
  for (const AgentBox& agent : motion.otherAgentsAt(key_time)) {
    for (const Vector2& corner : boxPixels(map_viewport_, agent.box)) placer.avoid(corner);
    placer.avoid(map_viewport_.toPixel(agent.box.center.position()));
  }
  if (view_.report.contact) {
    const std::string text = "contact " + signedSeconds(key_time - motion.now(), 2);
    contact_labels_.push_back(
        makeLabel(canvas, placer, motion.contactPoint(), text, options_.text_color));
  }
  const auto ego = motion.egoAt(motion.now());
  const auto attacker = motion.attackerAt(motion.now());
  if (ego) {
    now_labels_.push_back(
        makeLabel(canvas, placer, ego->center.position(), "ego now", options_.ego_color));
  }
  if (attacker) {
    now_labels_.push_back(makeLabel(canvas, placer, attacker->center.position(), "attacker now",
                                    options_.attacker_color));
  }
}

ScenarioPainter::Label ScenarioPainter::makeLabel(Canvas& canvas, LabelPlacer& placer,
                                                  const Vector2& world, const std::string& text,
                                                  const Color& color) const {
  const double font = size_.font_size;
  const double width = canvas.textWidth(text, {color, font, true, TextAlign::kLeft}) + 0.8 * font;
  const Vector2 anchor = map_viewport_.toPixel(world);
  return {placer.place(anchor, width, 1.5 * font), anchor, text, color};
}

void ScenarioPainter::paintLabel(Canvas& canvas, const Label& label) const {
  const double font = size_.font_size;
  // The line to the label starts beside the mark.
  const Vector2 towards = (label.place.center() - label.anchor).normalized();
  canvas.stroke({label.anchor + 0.8 * font * towards, label.place.center()},
                {label.color, 0.08 * font, 0.7, 0.0, false});
  canvas.fillRect(label.place, options_.background_color, 0.9);
  canvas.text(label.place.center() + Vector2(0.0, 0.36 * font), label.text,
              {label.color, font, true, TextAlign::kCenter});
}

Image ScenarioPainter::paint(double time, double ghosts_from) const {
  Image image(background_);
  Canvas canvas(image);
  paintClock(canvas, layout_, size_, view_, options_, time);

  canvas.clip(layout_.map);
  scene_.paint(canvas, map_viewport_, time, ghosts_from);
  if (ghosts_from <= scene_.motion().now() + kTimeTolerance) {
    for (const Label& label : now_labels_) paintLabel(canvas, label);
  }
  if (time >= scene_.motion().keyTime() - kTimeTolerance) {
    for (const Label& label : contact_labels_) paintLabel(canvas, label);
  }
  paintScale(canvas, map_viewport_, size_, options_);
  canvas.unclip();

  const PixelRect& square = layout_.close_up;
  canvas.clip(square);
  const Vector2 center = scene_.motion().closeUpCenter(time);
  const Viewport close_up = closeUp(square, scene_, center, options_.close_up_extent);
  if (center != scene_.motion().contactPoint()) {
    canvas.fillRect(square, options_.background_color);
    scene_.paintGround(canvas, close_up);
  }
  scene_.paint(canvas, close_up, time, kNoGhosts);
  canvas.unclip();
  canvas.stroke({{square.x, square.y},
                 {square.x + square.width, square.y},
                 {square.x + square.width, square.y + square.height},
                 {square.x, square.y + square.height}},
                {options_.lane_color, 1.0, 1.0, 0.0, true});
  return image;
}

}  // namespace forge
