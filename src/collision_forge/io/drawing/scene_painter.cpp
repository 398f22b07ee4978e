#include "collision_forge/io/drawing/scene_painter.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "collision_forge/base/scene/number_words.h"
#include "collision_forge/io/drawing/box_painter.h"
#include "collision_forge/io/drawing/map_painter.h"

namespace forge {

namespace {

constexpr double kTimeTolerance = 1e-6;  // s
constexpr double kFarLess = 0.8;         // share of a height

/// Returns the extent of the points, m, across the direction `rightwards`.
double heightOf(const std::vector<Vector2>& points, double rightwards) {
  const Vector2 up(-std::sin(rightwards), std::cos(rightwards));
  Eigen::AlignedBox<double, 1> extent;
  for (const Vector2& point : points) extent.extend(Eigen::Matrix<double, 1, 1>(up.dot(point)));
  return extent.isEmpty() ? 0.0 : extent.sizes()[0];
}

std::vector<Vector2> centers(const Viewport& viewport, const std::vector<OrientedBox>& boxes) {
  std::vector<Vector2> pixels;
  pixels.reserve(boxes.size());
  for (const OrientedBox& box : boxes) pixels.push_back(viewport.toPixel(box.center.position()));
  return pixels;
}

}  // namespace

void checkDrawable(const ScenarioView& view, const DrawingOptions& options) {
  if (options.gif_frames_per_second <= 0 || options.ghost_interval <= 0 ||
      options.min_extent <= 0 || options.close_up_extent <= 0) {
    throw std::runtime_error("drawing options: rate, interval and extents must be above 0");
  }
  const std::vector<TrajectoryPoint>& points = view.trajectory.points;
  if (points.empty()) throw std::runtime_error("the attacker's trajectory is empty");
  if (view.future.ego.states.empty()) throw std::runtime_error("the ego's future is empty");
  const double key_time = ScenarioMotion(view).keyTime();
  const bool spanned = key_time >= view.snapshot.now - kTimeTolerance &&
                       key_time <= points.back().time + kTimeTolerance;
  if (!spanned) {
    throw std::runtime_error("the attacker's trajectory does not cover now to the contact at " +
                             numberText(key_time) + " s");
  }
}

ScenePainter::ScenePainter(const ScenarioView& view, const DrawingOptions& options,
                           double mark_size, PictureKind kind)
    : view_(view), options_(options), mark_size_(mark_size), kind_(kind), motion_(view) {}

double ScenePainter::rightwards() const {
  const std::vector<Vector2> shown = shownCorners(trailsFrom());
  double best = 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (const double time : {motion_.now(), motion_.keyTime()}) {
    const auto ego = motion_.egoAt(time);
    if (!ego) continue;
    const double direction = std::atan(std::tan(ego->center.yaw));
    const double height = heightOf(shown, direction);
    if (height > kFarLess * least) continue;
    best = direction;
    least = height;
  }
  return best;
}

double ScenePainter::trailsFrom() const { return motion_.now() - options_.seconds_before_now; }

std::vector<Vector2> ScenePainter::shownCorners(double from) const {
  std::vector<Vector2> points;
  for (const auto& boxes : {motion_.egoBoxes(from, motion_.standTime()),
                            motion_.attackerBoxes(from, motion_.standTime())}) {
    for (const OrientedBox& box : boxes) {
      for (const Vector2& corner : corners(box)) points.push_back(corner);
    }
  }
  return points;
}

void ScenePainter::paintGround(Canvas& canvas, const Viewport& viewport) const {
  if (view_.snapshot.map == nullptr) return;
  paintMap(canvas, viewport, *view_.snapshot.map, options_, 0.09 * mark_size_);
}

void ScenePainter::paint(Canvas& canvas, const Viewport& viewport, double time,
                         double ghosts_from) const {
  paintLights(canvas, viewport, time);
  paintRecorded(canvas, viewport, time);
  if (kind_ == PictureKind::kStill) {
    paintPassed(canvas, viewport);
    paintRest(canvas, viewport);
  }
  paintTrails(canvas, viewport);
  paintGhosts(canvas, viewport, ghosts_from);
  paintVehicles(canvas, viewport, time);
  paintPattern(canvas, viewport);
  if (view_.report.contact && time >= motion_.keyTime() - kTimeTolerance) {
    paintStar(canvas, viewport.toPixel(motion_.contactPoint()), 0.75 * mark_size_,
              options_.contact_color, options_.text_color, 0.08 * mark_size_);
  }
}

void ScenePainter::paintLights(Canvas& canvas, const Viewport& viewport, double time) const {
  for (const TrafficLight& light : view_.lights) {
    const LightColor color = colorAt(light, time);
    if (color == LightColor::kUnknown) continue;
    const Color& shown = color == LightColor::kRed      ? options_.red_light_color
                         : color == LightColor::kYellow ? options_.yellow_light_color
                                                        : options_.green_light_color;
    canvas.fillCircle(viewport.toPixel(light.stop_point), 0.35 * mark_size_, shown);
  }
}

void ScenePainter::paintTrails(Canvas& canvas, const Viewport& viewport) const {
  const double now = motion_.now();
  const double from = trailsFrom();
  const double width = 0.18 * mark_size_;
  const double dash = 0.45 * mark_size_;
  canvas.stroke(centers(viewport, motion_.egoBoxes(from, now)), {options_.ego_color, width});
  canvas.stroke(centers(viewport, motion_.attackerBoxes(from, now)),
                {options_.attacker_color, width});
  canvas.stroke(centers(viewport, motion_.egoBoxes(now, motion_.keyTime())),
                {options_.ego_color, width, 1.0, dash, false});
  canvas.stroke(centers(viewport, motion_.attackerBoxes(now, motion_.keyTime())),
                {options_.attacker_color, width, 1.0, dash, false});
}

void ScenePainter::paintGhosts(Canvas& canvas, const Viewport& viewport, double from) const {
  const double step = options_.ghost_interval;
  const double width = 0.08 * mark_size_;
  for (int i = 0; motion_.now() + i * step < motion_.keyTime() - step / 4; ++i) {
    const double time = motion_.now() + i * step;
    if (time < from - kTimeTolerance) continue;
    // The boxes at t0 are stronger: they mark the end of the solid trail.
    const double opacity = (i == 0 ? 2 : 1) * options_.ghost_opacity;
    const auto ego = motion_.egoAt(time);
    const auto attacker = motion_.attackerAt(time);
    if (ego) paintGhost(canvas, viewport, *ego, options_.ego_color, opacity, width);
    if (attacker) paintGhost(canvas, viewport, *attacker, options_.attacker_color, opacity, width);
  }
}

void ScenePainter::paintRecorded(Canvas& canvas, const Viewport& viewport, double time) const {
  const double font = mark_size_;
  const auto boxes = motion_.recordedAttackerBoxes(motion_.now(), motion_.keyTime());
  canvas.stroke(centers(viewport, boxes),
                {options_.recorded_attacker_color, 0.09 * font, 1.0, 0.3 * font, false});
  const auto recorded = motion_.recordedAttackerAt(time);
  if (recorded) {
    paintGhost(canvas, viewport, *recorded, options_.recorded_attacker_color,
               options_.ghost_opacity, 0.08 * font);
  }
}

const Color& ScenePainter::colorOf(const AgentBox& agent) const {
  return agent.is_support ? options_.support_color : options_.agent_color;
}

void ScenePainter::paintPassed(Canvas& canvas, const Viewport& viewport) const {
  const double width = 0.08 * mark_size_;
  for (const ScenarioMotion::Passed& other : motion_.passedAgents()) {
    const Color& color = colorOf(other.then);
    paintGhost(canvas, viewport, other.then.box, color, options_.ghost_opacity, width);
    canvas.stroke(centers(viewport, {other.then.box, other.at_key_time.box}), {color, 2 * width});
  }
}

void ScenePainter::paintRest(Canvas& canvas, const Viewport& viewport) const {
  if (!hasRest(view_)) return;
  const double from = motion_.keyTime();
  const double rest = motion_.standTime();
  const double width = 0.08 * mark_size_;
  const auto show = [&](const std::vector<OrientedBox>& way, const Color& color) {
    canvas.stroke(centers(viewport, way), {color, width, 1.0, 0.3 * mark_size_, false});
    paintGhost(canvas, viewport, way.back(), color, kRestGhosts * options_.ghost_opacity, width);
  };
  show(motion_.egoBoxes(from, rest), options_.ego_color);
  show(motion_.attackerBoxes(from, rest), options_.attacker_color);
}

void ScenePainter::paintVehicles(Canvas& canvas, const Viewport& viewport, double time) const {
  const double width = 0.09 * mark_size_;
  for (const AgentBox& agent : motion_.otherAgentsAt(time)) {
    paintAgent(canvas, viewport, agent, colorOf(agent), width);
  }
  const auto ego = motion_.egoAt(time);
  const auto attacker = motion_.attackerAt(time);
  if (attacker) paintVehicle(canvas, viewport, *attacker, options_.attacker_color, width);
  if (ego) paintVehicle(canvas, viewport, *ego, options_.ego_color, width);
}

void ScenePainter::paintPattern(Canvas& canvas, const Viewport& viewport) const {
  const double width = 0.13 * mark_size_;
  paintOutline(canvas, viewport, view_.pattern.ego, options_.pattern_ego_color,
               options_.background_color, width);
  paintOutline(canvas, viewport, patternAttackerBox(view_), options_.pattern_attacker_color,
               options_.background_color, width);
}

}  // namespace forge
