#include "collision_forge/drawing/scenario_painter.h"

#include <limits>

#include "collision_forge/drawing/box_painter.h"
#include "collision_forge/drawing/decimal_text.h"
#include "collision_forge/drawing/map_painter.h"

namespace forge {

namespace {

constexpr double kTimeTolerance = 1e-6;  // s
constexpr double kNoGhosts = std::numeric_limits<double>::infinity();

std::vector<Vector2> centers(const Viewport& viewport, const std::vector<OrientedBox>& boxes) {
  std::vector<Vector2> pixels;
  pixels.reserve(boxes.size());
  for (const OrientedBox& box : boxes) pixels.push_back(viewport.toPixel(box.center.position()));
  return pixels;
}

Viewport closeUp(const PixelRect& area, const Vector2& center, double extent) {
  return {area, center, area.width / extent};
}

}  // namespace

ScenarioPainter::ScenarioPainter(const ScenarioView& view, const DrawingOptions& options,
                                 const FigureSize& size, PictureKind kind)
    : view_(view),
      options_(options),
      size_(size),
      kind_(kind),
      motion_(view),
      layout_(layoutFigure(size)),
      map_viewport_(fitMap()),
      close_up_viewport_(
          closeUp(layout_.close_up, motion_.contactPoint(), options.close_up_extent)),
      background_(size.width, size.height, options.background_color) {
  paintBackground();
  placeLabels();
}

Viewport ScenarioPainter::fitMap() const {
  const double from = motion_.now() - options_.seconds_before_now;
  std::vector<OrientedBox> boxes = motion_.egoBoxes(from, motion_.keyTime());
  for (const OrientedBox& box : motion_.attackerBoxes(from, motion_.keyTime())) {
    boxes.push_back(box);
  }
  std::vector<Vector2> points = {motion_.contactPoint()};
  for (const OrientedBox& box : boxes) {
    for (const Vector2& corner : corners(box)) points.push_back(corner);
  }
  return fitViewport(layout_.map, points, options_.view_margin, options_.min_extent);
}

void ScenarioPainter::paintBackground() {
  Canvas canvas(background_);
  if (view_.snapshot.map != nullptr) {
    for (const Viewport& viewport : {map_viewport_, close_up_viewport_}) {
      canvas.clip(viewport.area());
      paintMap(canvas, viewport, *view_.snapshot.map, options_, 0.09 * size_.font_size);
      canvas.unclip();
    }
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
  const double from = motion_.now() - options_.seconds_before_now;
  const double key_time = motion_.keyTime();
  for (const auto& boxes :
       {motion_.egoBoxes(from, key_time), motion_.attackerBoxes(from, key_time)}) {
    for (const OrientedBox& box : boxes) {
      for (const Vector2& corner : boxPixels(map_viewport_, box)) placer.avoid(corner);
    }
  }
  for (const AgentBox& agent : motion_.othersAt(key_time)) {
    for (const Vector2& corner : boxPixels(map_viewport_, agent.box)) placer.avoid(corner);
    placer.avoid(map_viewport_.toPixel(agent.box.center.position()));
  }
  if (view_.report.contact) {
    const std::string text = "contact " + signedSeconds(key_time - motion_.now(), 2);
    contact_labels_.push_back(
        makeLabel(canvas, placer, motion_.contactPoint(), text, options_.text_color));
  }
  const auto ego = motion_.egoAt(motion_.now());
  const auto attacker = motion_.attackerAt(motion_.now());
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
  // The line to the label starts beside the mark that it names.
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
  paintScene(canvas, map_viewport_, time, ghosts_from);
  if (ghosts_from <= motion_.now() + kTimeTolerance) {
    for (const Label& label : now_labels_) paintLabel(canvas, label);
  }
  if (time >= motion_.keyTime() - kTimeTolerance) {
    for (const Label& label : contact_labels_) paintLabel(canvas, label);
  }
  paintScale(canvas, map_viewport_, size_, options_);
  canvas.unclip();

  const PixelRect& square = layout_.close_up;
  canvas.clip(square);
  paintScene(canvas, close_up_viewport_, time, kNoGhosts);
  canvas.unclip();
  canvas.stroke({{square.x, square.y},
                 {square.x + square.width, square.y},
                 {square.x + square.width, square.y + square.height},
                 {square.x, square.y + square.height}},
                {options_.lane_color, 1.0, 1.0, 0.0, true});
  return image;
}

void ScenarioPainter::paintScene(Canvas& canvas, const Viewport& viewport, double time,
                                 double ghosts_from) const {
  const double font = size_.font_size;
  paintRecorded(canvas, viewport, time);
  if (kind_ == PictureKind::kStill) paintPassed(canvas, viewport);
  paintTrails(canvas, viewport);
  paintGhosts(canvas, viewport, ghosts_from);
  paintVehicles(canvas, viewport, time);
  paintOutline(canvas, viewport, view_.pattern.ego, options_.pattern_ego_color,
               options_.background_color, 0.13 * font);
  paintOutline(canvas, viewport, patternAttackerBox(view_), options_.pattern_attacker_color,
               options_.background_color, 0.13 * font);
  if (view_.report.contact && time >= motion_.keyTime() - kTimeTolerance) {
    paintStar(canvas, viewport.toPixel(motion_.contactPoint()), 0.75 * font, options_.contact_color,
              options_.text_color, 0.08 * font);
  }
}

void ScenarioPainter::paintTrails(Canvas& canvas, const Viewport& viewport) const {
  const double now = motion_.now();
  const double from = now - options_.seconds_before_now;
  const double width = 0.18 * size_.font_size;
  const double dash = 0.45 * size_.font_size;
  canvas.stroke(centers(viewport, motion_.egoBoxes(from, now)), {options_.ego_color, width});
  canvas.stroke(centers(viewport, motion_.attackerBoxes(from, now)),
                {options_.attacker_color, width});
  canvas.stroke(centers(viewport, motion_.egoBoxes(now, motion_.keyTime())),
                {options_.ego_color, width, 1.0, dash, false});
  canvas.stroke(centers(viewport, motion_.attackerBoxes(now, motion_.keyTime())),
                {options_.attacker_color, width, 1.0, dash, false});
}

void ScenarioPainter::paintGhosts(Canvas& canvas, const Viewport& viewport, double from) const {
  const double step = options_.ghost_interval;
  const double width = 0.08 * size_.font_size;
  for (int i = 0; motion_.now() + i * step < motion_.keyTime() - step / 4; ++i) {
    const double time = motion_.now() + i * step;
    if (time < from - kTimeTolerance) continue;
    // The boxes at now stand out: they tell where the solid trail ends.
    const double opacity = (i == 0 ? 2 : 1) * options_.ghost_opacity;
    const auto ego = motion_.egoAt(time);
    const auto attacker = motion_.attackerAt(time);
    if (ego) paintGhost(canvas, viewport, *ego, options_.ego_color, opacity, width);
    if (attacker) paintGhost(canvas, viewport, *attacker, options_.attacker_color, opacity, width);
  }
}

void ScenarioPainter::paintRecorded(Canvas& canvas, const Viewport& viewport, double time) const {
  const double font = size_.font_size;
  const auto boxes = motion_.recordedAttackerBoxes(motion_.now(), motion_.keyTime());
  canvas.stroke(centers(viewport, boxes),
                {options_.recorded_attacker_color, 0.09 * font, 1.0, 0.3 * font, false});
  const auto recorded = motion_.recordedAttackerAt(time);
  if (recorded) {
    paintGhost(canvas, viewport, *recorded, options_.recorded_attacker_color,
               options_.ghost_opacity, 0.08 * font);
  }
}

void ScenarioPainter::paintPassed(Canvas& canvas, const Viewport& viewport) const {
  const double width = 0.08 * size_.font_size;
  for (const ScenarioMotion::Passed& other : motion_.passedOthers()) {
    paintGhost(canvas, viewport, other.then.box, options_.agent_color, options_.ghost_opacity,
               width);
    canvas.stroke(centers(viewport, {other.then.box, other.at_key_time.box}),
                  {options_.agent_color, 2 * width});
  }
}

void ScenarioPainter::paintVehicles(Canvas& canvas, const Viewport& viewport, double time) const {
  const double width = 0.09 * size_.font_size;
  for (const AgentBox& agent : motion_.othersAt(time)) {
    paintAgent(canvas, viewport, agent, options_.agent_color, width);
  }
  const auto ego = motion_.egoAt(time);
  const auto attacker = motion_.attackerAt(time);
  if (attacker) paintVehicle(canvas, viewport, *attacker, options_.attacker_color, width);
  if (ego) paintVehicle(canvas, viewport, *ego, options_.ego_color, width);
}

}  // namespace forge
