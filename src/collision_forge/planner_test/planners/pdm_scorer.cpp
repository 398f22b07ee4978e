#include "collision_forge/planner_test/planners/pdm_scorer.h"

#include <algorithm>
#include <cmath>

namespace forge {
namespace {

std::vector<bool> areRedLights(const PdmForecast& forecast) {
  std::vector<bool> are_lights;
  for (const ForecastAgent& agent : forecast.agents()) are_lights.push_back(agent.is_red_light);
  return are_lights;
}

}  // namespace

PdmScorer::PdmScorer(const PdmSurroundings& surroundings, const PdmScoringOptions& options)
    : surroundings_(surroundings),
      options_(options),
      ahead_cosine_(std::cos(options.ahead_angle)),
      behind_cosine_(std::cos(options.behind_angle)) {
  for (const double time : options.ttc_times) {
    ttc_steps_.push_back(
        static_cast<std::size_t>(std::lround(time / surroundings.forecast.step())));
  }
}

std::vector<PdmScore> PdmScorer::score(const std::vector<PdmMotion>& motions) const {
  std::vector<PdmScore> scores;
  double farthest = 0.0;
  for (const PdmMotion& motion : motions) {
    PdmScore& score = scores.emplace_back();
    Places places;
    for (const OrientedBox& box : motion.boxes) places.push_back(surroundings_.map.placeOf(box));
    scoreCollisions(motion, places, score);
    const bool leaves = std::any_of(places.begin(), places.end(),
                                    [](const PdmPlace& place) { return place.is_off_road; });
    score.drivable_area = leaves ? 0.0 : 1.0;
    score.driving_direction = drivingDirection(motion, places);
    const PdmPath& line = surroundings_.centerline;
    score.driven = std::max(line.project(motion.boxes.back().center.position()) -
                                line.project(motion.boxes.front().center.position()),
                            0.0);
    scoreTimeToCollision(motion, places, score);
    score.comfort = surroundings_.comfort.isComfortable(motion.states) ? 1.0 : 0.0;
    score.total = score.collision * score.drivable_area * score.driving_direction;
    farthest = std::max(farthest, score.total * score.driven);
  }
  const double weights = options_.progress_weight + options_.ttc_weight + options_.comfort_weight;
  for (PdmScore& score : scores) {
    score.progress = score.total > 0.0 ? 1.0 : 0.0;
    if (farthest > options_.min_progress) score.progress = score.total * score.driven / farthest;
    score.total *=
        (options_.progress_weight * score.progress + options_.ttc_weight * score.time_to_collision +
         options_.comfort_weight * score.comfort) /
        weights;
  }
  return scores;
}

void PdmScorer::scoreCollisions(const PdmMotion& motion, const Places& places,
                                PdmScore& score) const {
  const PdmForecast& forecast = surroundings_.forecast;
  std::vector<bool> is_ignored = areRedLights(forecast);
  for (std::size_t step = 0; step < motion.states.size(); ++step) {
    const OrientedBox& box = motion.boxes[step];
    forecast.forTouching(box, circumradius(box.size), step, [&](std::size_t agent) {
      if (is_ignored[agent]) return;
      if (!isAtFault(motion, places[step], agent, step)) {
        is_ignored[agent] = true;
        return;
      }
      const bool is_static = forecast.agents()[agent].is_static_object;
      score.collision =
          std::min(score.collision, is_static ? options_.static_collision_score : 0.0);
      if (!score.collision_time) {
        score.collision_time = static_cast<double>(step) * forecast.step();
      }
    });
  }
}

bool PdmScorer::isAtFault(const PdmMotion& motion, const PdmPlace& place, std::size_t agent,
                          std::size_t step) const {
  const PdmForecast& forecast = surroundings_.forecast;
  if (std::abs(motion.states[step].speed) <= options_.standing_speed) return false;
  if (forecast.agents()[agent].is_standing) return true;
  if (cosineTo(motion.states[step], forecast.positions(step)[agent]) < behind_cosine_) return false;
  if (overlaps(frontEdge(motion.boxes[step]), forecast.box(agent, step))) return true;
  return place.is_in_several_lanes || place.is_off_road;
}

void PdmScorer::scoreTimeToCollision(const PdmMotion& motion, const Places& places,
                                     PdmScore& score) const {
  std::vector<bool> is_ignored = areRedLights(surroundings_.forecast);
  for (std::size_t step = 0; step < motion.states.size(); ++step) {
    if (std::abs(motion.states[step].speed) < options_.ttc_standing_speed) continue;
    if (!isTooClose(motion, places[step], step, is_ignored)) continue;
    score.time_to_collision = 0.0;
    score.ttc_time = static_cast<double>(step) * surroundings_.forecast.step();
    return;
  }
}

bool PdmScorer::isTooClose(const PdmMotion& motion, const PdmPlace& place, std::size_t step,
                           std::vector<bool>& is_ignored) const {
  const PdmForecast& forecast = surroundings_.forecast;
  const BicycleState& state = motion.states[step];
  const OrientedBox& now = motion.boxes[step];
  const Vector2 heading = now.center.heading();
  bool is_too_close = false;
  for (const std::size_t ahead : ttc_steps_) {
    const double driven = std::abs(state.speed) * static_cast<double>(ahead) * forecast.step();
    const OrientedBox box{
        {now.center.x + driven * heading.x(), now.center.y + driven * heading.y(), now.center.yaw},
        now.size};
    forecast.forTouching(box, circumradius(box.size), step + ahead, [&](std::size_t agent) {
      if (is_ignored[agent] || is_too_close) return;
      const double cosine = cosineTo(state, forecast.positions(step + ahead)[agent]);
      is_too_close = cosine > ahead_cosine_ ||
                     (cosine >= behind_cosine_ &&
                      (place.is_in_several_lanes || place.is_off_road ||
                       surroundings_.map.isInIntersection(state.rear_axle.position())));
      is_ignored[agent] = !is_too_close;
    });
  }
  return is_too_close;
}

double PdmScorer::drivingDirection(const PdmMotion& motion, const Places& places) const {
  double run = 0.0;
  double longest = 0.0;
  for (std::size_t step = 1; step < places.size(); ++step) {
    const Vector2 moved =
        motion.boxes[step].center.position() - motion.boxes[step - 1].center.position();
    run = places[step].is_wrong_way ? run + moved.norm() : 0.0;
    longest = std::max(longest, run);
  }
  if (longest < options_.wrong_way_distance) return 1.0;
  return longest < options_.max_wrong_way_distance ? options_.wrong_way_score : 0.0;
}

double PdmScorer::cosineTo(const BicycleState& state, const Vector2& point) {
  const Vector2 offset = point - state.rear_axle.position();
  return state.rear_axle.heading().dot(offset) / std::max(offset.norm(), 1e-9);
}

}  // namespace forge
