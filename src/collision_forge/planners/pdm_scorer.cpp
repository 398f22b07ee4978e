#include "collision_forge/planners/pdm_scorer.h"

#include <algorithm>
#include <cmath>

#include "collision_forge/planners/pdm_comfort.h"

namespace forge {

PdmScorer::PdmScorer(const PdmSurroundings& surroundings, double map_radius,
                     const PdmScoringOptions& options)
    : surroundings_(surroundings),
      map_radius_(map_radius),
      options_(options),
      ego_radius_(circumradius(surroundings.ego.size)),
      ahead_cosine_(std::cos(options.ahead_angle)),
      behind_cosine_(std::cos(options.behind_angle)) {
  for (const double time : options.ttc_times) {
    ttc_steps_.push_back(
        static_cast<std::size_t>(std::lround(time / surroundings.forecast.step())));
  }
}

PdmCollision PdmScorer::collision(const PdmMotion& motion) const {
  const PdmForecast& forecast = surroundings_.forecast;
  std::vector<bool> let_alone(forecast.agents().size(), false);
  PdmCollision collision;
  for (std::size_t step = 0; step < motion.states.size(); ++step) {
    const OrientedBox& box = motion.boxes[step];
    forecast.forTouching(box, ego_radius_, step, [&](std::size_t agent) {
      if (let_alone[agent]) return;
      let_alone[agent] = true;
      if (!isAtFault(motion.states[step], box, agent, step)) return;
      const bool is_static = forecast.agents()[agent].is_static_object;
      collision.score =
          std::min(collision.score, is_static ? options_.static_collision_score : 0.0);
      if (!collision.time) collision.time = static_cast<double>(step) * forecast.step();
    });
  }
  return collision;
}

bool PdmScorer::isAtFault(const BicycleState& state, const OrientedBox& box, std::size_t agent,
                          std::size_t step) const {
  if (state.speed <= options_.standing_speed) return false;
  if (surroundings_.forecast.agents()[agent].is_standing) return true;
  if (cosineTo(state, agent, step) < behind_cosine_) return false;
  const OrientedBox front{compose(box.center, {0.5 * box.size.length, 0.0, 0.0}),
                          {0.0, box.size.width}};
  if (overlaps(front, surroundings_.forecast.box(agent, step))) return true;
  return isInSeveralLanesOrOffRoad(box);
}

double PdmScorer::drivableArea(const PdmMotion& motion) const {
  const bool leaves = std::any_of(motion.boxes.begin(), motion.boxes.end(),
                                  [&](const OrientedBox& box) { return isOffRoad(box); });
  return leaves ? 0.0 : 1.0;
}

double PdmScorer::drivingDirection(const PdmMotion& motion) const {
  const auto window = static_cast<std::size_t>(
      std::lround(options_.wrong_way_time / surroundings_.forecast.step()));
  std::size_t hint = surroundings_.way_sample;
  std::vector<double> against = {0.0};  // m driven against the traffic up to each step
  double farthest = 0.0;
  for (std::size_t step = 1; step < motion.boxes.size(); ++step) {
    const Pose2& middle = motion.boxes[step].center;
    const SampledWay::Projection place = surroundings_.way.project(middle.position(), hint);
    hint = place.sample;
    const bool is_on_way = std::abs(place.lateral) <= options_.route_distance;
    const bool is_oncoming = !is_on_way && areas().isOncoming(middle);
    const double driven = (middle.position() - motion.boxes[step - 1].center.position()).norm();
    against.push_back(against.back() + (is_oncoming ? driven : 0.0));
    farthest = std::max(farthest, against.back() - against[step < window ? 0 : step - window]);
  }
  if (farthest < options_.wrong_way_distance) return 1.0;
  return farthest < options_.max_wrong_way_distance ? options_.wrong_way_score : 0.0;
}

double PdmScorer::timeToCollision(const PdmMotion& motion) const {
  std::vector<bool> let_alone(surroundings_.forecast.agents().size(), false);
  for (std::size_t step = 0; step < motion.states.size(); ++step) {
    if (motion.states[step].speed <= options_.standing_speed) continue;
    if (isTooClose(motion, step, let_alone)) return 0.0;
  }
  return 1.0;
}

bool PdmScorer::isTooClose(const PdmMotion& motion, std::size_t step,
                           std::vector<bool>& let_alone) const {
  const PdmForecast& forecast = surroundings_.forecast;
  const BicycleState& state = motion.states[step];
  bool is_too_close = false;
  for (const std::size_t ahead : ttc_steps_) {
    const double driven = state.speed * static_cast<double>(ahead) * forecast.step();
    const OrientedBox box{compose(motion.boxes[step].center, {driven, 0.0, 0.0}),
                          surroundings_.ego.size};
    forecast.forTouching(box, ego_radius_, step + ahead, [&](std::size_t agent) {
      if (let_alone[agent] || is_too_close) return;
      const double cosine = cosineTo(state, agent, step);
      is_too_close = cosine > ahead_cosine_ ||
                     (cosine >= behind_cosine_ && isInSeveralLanesOrOffRoad(motion.boxes[step]));
      let_alone[agent] = !is_too_close;
    });
  }
  return is_too_close;
}

double PdmScorer::comfort(const PdmMotion& motion) const {
  return isComfortable(motion, surroundings_.bicycle, surroundings_.forecast.step(),
                       options_.comfort)
             ? 1.0
             : 0.0;
}

double PdmScorer::progress(const PdmMotion& motion) const {
  std::size_t hint = surroundings_.way_sample;
  const double start =
      surroundings_.way.project(motion.boxes.front().center.position(), hint).arc_length;
  const double end =
      surroundings_.way.project(motion.boxes.back().center.position(), hint).arc_length;
  return std::max(end - start, 0.0);
}

std::vector<PdmScore> PdmScorer::score(const std::vector<PdmMotion>& motions) const {
  std::vector<PdmScore> scores;
  std::vector<double> distances;
  double farthest = 0.0;
  for (const PdmMotion& motion : motions) {
    PdmScore score;
    score.collision = collision(motion);
    score.drivable_area = drivableArea(motion);
    score.driving_direction = drivingDirection(motion);
    score.time_to_collision = timeToCollision(motion);
    score.comfort = comfort(motion);
    score.total = score.collision.score * score.drivable_area * score.driving_direction;
    distances.push_back(score.total * progress(motion));
    farthest = std::max(farthest, distances.back());
    scores.push_back(score);
  }
  const double weights = options_.progress_weight + options_.ttc_weight + options_.comfort_weight;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    PdmScore& score = scores[i];
    score.progress = farthest > options_.min_progress ? distances[i] / farthest : 1.0;
    score.total *=
        (options_.progress_weight * score.progress + options_.ttc_weight * score.time_to_collision +
         options_.comfort_weight * score.comfort) /
        weights;
  }
  return scores;
}

bool PdmScorer::isOffRoad(const OrientedBox& box) const {
  const AreaRaster& drivable = surroundings_.lanes.drivable();
  if (drivable.empty()) return false;
  const std::array<Vector2, 4> outline = corners(shrunk(box, options_.drivable_margin));
  return !std::all_of(outline.begin(), outline.end(),
                      [&](const Vector2& corner) { return drivable.contains(corner); });
}

bool PdmScorer::isInSeveralLanesOrOffRoad(const OrientedBox& box) const {
  return isOffRoad(box) || areas().inSeveralLanes(box);
}

double PdmScorer::cosineTo(const BicycleState& state, std::size_t agent, std::size_t step) const {
  const Vector2 offset = surroundings_.forecast.positions(step)[agent] - state.rear_axle.position();
  return state.rear_axle.heading().dot(offset) / std::max(offset.norm(), 1e-9);
}

const LaneAreas& PdmScorer::areas() const {
  if (!areas_) {
    areas_.emplace(surroundings_.lanes, surroundings_.start.position(), map_radius_);
  }
  return *areas_;
}

}  // namespace forge
