#include "collision_forge/base/scene/attack.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace forge {

PatternMiss missBetween(const Pose2& expected, const Pose2& actual) {
  return {(actual.position() - expected.position()).norm(),
          std::abs(angleBetween(expected.yaw, actual.yaw))};
}

double cornerMiss(const PatternMiss& miss, const BoxSize& attacker) {
  return miss.distance + circumradius(attacker) * miss.heading;
}

std::vector<AgentState> toStates(const std::vector<TrajectoryPoint>& points) {
  std::vector<AgentState> states;
  for (const TrajectoryPoint& point : points) {
    states.push_back({point.time, point.pose, point.speed * point.pose.heading()});
  }
  return states;
}

Pose2 poseAt(const AttackerTrajectory& trajectory, double time) {
  const auto& points = trajectory.points;
  const auto after = std::lower_bound(
      points.begin(), points.end(), time,
      [](const TrajectoryPoint& point, double value) { return point.time < value; });
  if (after == points.begin()) return points.front().pose;
  if (after == points.end()) return points.back().pose;
  const TrajectoryPoint& before = *std::prev(after);
  return interpolate(before.pose, after->pose, (time - before.time) / (after->time - before.time));
}

Realization declined(Status status) {
  Realization answer;
  answer.status = std::move(status);
  return answer;
}

}  // namespace forge
