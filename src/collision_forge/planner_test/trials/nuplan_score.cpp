#include "collision_forge/planner_test/trials/nuplan_score.h"

#include <algorithm>
#include <cmath>

namespace forge {
namespace {

constexpr double kTtcStep = 0.1;  // s between the predicted times that are tested; nuPlan

Eigen::VectorXd filtered(const std::vector<double>& values, int window, int order, int derivative,
                         double step) {
  const int count = static_cast<int>(values.size());
  const Eigen::Map<const Eigen::VectorXd> given(values.data(), count);
  return savitzkyGolay(count, std::min(window, count), order, derivative, step) * given;
}

bool isWithin(const Eigen::VectorXd& values, double low, double high) {
  return values.minCoeff() > low && values.maxCoeff() < high;
}

bool isWithin(const Eigen::VectorXd& values, double limit) {
  return isWithin(values, -limit, limit);
}

double progressShare(double driven, double recorded, double least) {
  if (driven < -least) return 0.0;
  return std::min(std::max(driven, least) / std::max(recorded, least), 1.0);
}

}  // namespace

const std::array<NuplanPart, 8>& nuplanParts() {
  static constexpr std::array<NuplanPart, 8> kParts = {{
      {"no_at_fault_collision", &NuplanScore::no_at_fault_collision},
      {"drivable_area", &NuplanScore::drivable_area},
      {"driving_direction", &NuplanScore::driving_direction},
      {"making_progress", &NuplanScore::making_progress},
      {"time_to_collision", &NuplanScore::time_to_collision},
      {"comfort", &NuplanScore::comfort},
      {"progress", &NuplanScore::progress},
      {"score", &NuplanScore::total},
  }};
  return kParts;
}

NuplanJudge::NuplanJudge(const PdmMap& map, const EgoVehicle& ego, const PdmScoringOptions& scoring,
                         const NuplanScoreOptions& options)
    : map_(map), ego_(ego), scoring_(scoring), options_(options) {}

void NuplanJudge::addStep(const TrajectoryPoint& ego, const std::vector<Track>& agents,
                          const std::set<std::string>& ignored) {
  const PdmPlace place = map_.placeOf({ego.pose, ego_.size});
  driven_.push_back(ego);
  is_wrong_way_.push_back(place.is_wrong_way);
  if (place.speed_limit) {
    has_speed_limit_ = true;
    overspeed_ += std::max(ego.speed - *place.speed_limit, 0.0);
  }
  leaves_road_ = leaves_road_ || place.is_off_road;
  is_too_close_ = is_too_close_ || isTooClose(ego, place, agents, ignored);
}

NuplanScore NuplanJudge::score(const std::optional<NuplanContact>& contact, double driven,
                               double recorded) const {
  NuplanScore score;
  if (contact && contact->at_fault) {
    score.no_at_fault_collision = contact->is_static_object ? scoring_.static_collision_score : 0.0;
  }
  score.drivable_area = leaves_road_ ? 0.0 : 1.0;
  score.driving_direction = drivingDirection();
  score.progress = progressShare(driven, recorded, options_.least_progress);
  score.making_progress = score.progress > options_.min_progress_share ? 1.0 : 0.0;
  score.time_to_collision = is_too_close_ ? 0.0 : 1.0;
  score.comfort = isComfortable() ? 1.0 : 0.0;
  double weighted = options_.progress_weight * score.progress +
                    options_.ttc_weight * score.time_to_collision +
                    options_.comfort_weight * score.comfort;
  double weights = options_.progress_weight + options_.ttc_weight + options_.comfort_weight;
  if (has_speed_limit_) {
    const double mean = overspeed_ / static_cast<double>(driven_.size());
    score.speed_limit = std::max(1.0 - mean / options_.max_overspeed, 0.0);
    weighted += options_.speed_limit_weight * *score.speed_limit;
    weights += options_.speed_limit_weight;
  }
  score.total = score.no_at_fault_collision * score.drivable_area * score.driving_direction *
                score.making_progress * weighted / weights;
  return score;
}

bool NuplanJudge::isTooClose(const TrajectoryPoint& ego, const PdmPlace& place,
                             const std::vector<Track>& agents,
                             const std::set<std::string>& ignored) const {
  if (std::abs(ego.speed) < scoring_.ttc_standing_speed) return false;
  const Pose2 axle = compose(ego.pose, {-ego_.center_offset, 0.0, 0.0});
  const bool minds_sides = place.is_in_several_lanes || map_.isInIntersection(axle.position());
  const double reach = options_.ttc_horizon * ego.speed + circumradius(ego_.size);
  for (const Track& agent : agents) {
    if (ignored.count(agent.id) > 0) continue;
    const AgentState& now = agent.states.back();
    const Vector2 away = now.pose.position() - axle.position();
    const double farthest = reach + ego_.center_offset + circumradius(agent.size) +
                            options_.ttc_horizon * now.velocity.norm();
    if (away.norm() > farthest) continue;
    const double angle =
        std::abs(std::atan2(relativeTo(axle, now.pose).y, relativeTo(axle, now.pose).x));
    if (angle > scoring_.behind_angle || (angle > scoring_.ahead_angle && !minds_sides)) continue;
    for (int step = 0; step * kTtcStep < options_.ttc_horizon; ++step) {
      const double elapsed = step * kTtcStep;
      const OrientedBox box{compose(ego.pose, {ego.speed * elapsed, 0.0, 0.0}), ego_.size};
      OrientedBox other = boxAt(agent, now.pose);
      other.center.x += now.velocity.x() * elapsed;
      other.center.y += now.velocity.y() * elapsed;
      if (overlaps(box, other)) return true;
    }
  }
  return false;
}

double NuplanJudge::drivingDirection() const {
  double farthest = 0.0;
  double sum = 0.0;
  std::size_t first = 1;
  const auto driven_at = [&](std::size_t step) {
    if (!is_wrong_way_[step]) return 0.0;
    return (driven_[step].pose.position() - driven_[step - 1].pose.position()).norm();
  };
  for (std::size_t step = 1; step < driven_.size(); ++step) {
    sum += driven_at(step);
    while (driven_[step].time - driven_[first - 1].time > options_.direction_window + 1e-6) {
      sum -= driven_at(first++);
    }
    farthest = std::max(farthest, sum);
  }
  if (farthest < scoring_.wrong_way_distance) return 1.0;
  return farthest < scoring_.max_wrong_way_distance ? scoring_.wrong_way_score : 0.0;
}

bool NuplanJudge::isComfortable() const {
  constexpr std::size_t kLeast = 5;  // states that a cubic fit needs
  if (driven_.size() < kLeast) return true;
  const double step =
      (driven_.back().time - driven_.front().time) / static_cast<double>(driven_.size() - 1);
  std::vector<double> longitudinal, lateral, magnitude, yaw;
  for (const TrajectoryPoint& point : driven_) {
    longitudinal.push_back(point.acceleration);
    lateral.push_back(point.speed * point.speed * point.curvature);
    magnitude.push_back(std::hypot(longitudinal.back(), lateral.back()));
    yaw.push_back(yaw.empty() ? point.pose.yaw
                              : yaw.back() + angleBetween(yaw.back(), point.pose.yaw));
  }
  const PdmComfortOptions& limits = scoring_.comfort;
  const auto smooth = [&](const std::vector<double>& values) {
    return filtered(values, options_.acceleration_window, 2, 0, step);
  };
  const auto rate = [&](const std::vector<double>& values) {
    const Eigen::VectorXd known = smooth(values);
    return filtered({known.data(), known.data() + known.size()}, options_.rate_window, 2, 1, step);
  };
  return isWithin(smooth(longitudinal), -limits.max_braking,
                  limits.max_longitudinal_acceleration) &&
         isWithin(smooth(lateral), limits.max_lateral_acceleration) &&
         isWithin(rate(magnitude), limits.max_jerk) &&
         isWithin(rate(longitudinal), limits.max_longitudinal_jerk) &&
         isWithin(filtered(yaw, options_.rate_window, 3, 2, step), limits.max_yaw_acceleration) &&
         isWithin(filtered(yaw, options_.rate_window, 2, 1, step), limits.max_yaw_rate);
}

}  // namespace forge
