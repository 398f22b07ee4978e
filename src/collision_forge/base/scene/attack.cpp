#include "collision_forge/base/scene/attack.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "collision_forge/base/geometry/enum_words.h"

namespace forge {

static constexpr EnumWord<SupportRole> kRoleWords[] = {
    {SupportRole::kParkedVehicle, "parked_vehicle"},
    {SupportRole::kLeader, "leader"},
    {SupportRole::kQueue, "queue"},
};

const char* toString(SupportRole role) { return wordOf(kRoleWords, role); }

std::optional<SupportRole> supportRoleFromString(const std::string& name) {
  return valueOf(kRoleWords, name);
}

PatternMiss missBetween(const Pose2& expected, const Pose2& actual) {
  return {(actual.position() - expected.position()).norm(),
          std::abs(angleBetween(expected.yaw, actual.yaw))};
}

double cornerMiss(const PatternMiss& miss, const BoxSize& attacker) {
  return miss.distance + circumradius(attacker) * miss.heading;
}

TrajectoryPoint pointAt(const std::vector<TrajectoryPoint>& points, double time) {
  const auto after = std::lower_bound(
      points.begin(), points.end(), time,
      [](const TrajectoryPoint& point, double value) { return point.time < value; });
  if (after == points.begin()) return points.front();
  if (after == points.end()) return points.back();
  const TrajectoryPoint& before = *std::prev(after);
  const double ratio = (time - before.time) / (after->time - before.time);
  TrajectoryPoint point = before;
  point.time = time;
  point.pose = interpolate(before.pose, after->pose, ratio);
  point.speed += ratio * (after->speed - before.speed);
  return point;
}

std::vector<AgentState> toStates(const std::vector<TrajectoryPoint>& points) {
  std::vector<AgentState> states;
  for (const TrajectoryPoint& point : points) {
    states.push_back({point.time, point.pose, point.speed * point.pose.heading()});
  }
  return states;
}

Pose2 poseAt(const AttackerTrajectory& trajectory, double time) {
  return pointAt(trajectory.points, time).pose;
}

Attack rejection(Status status) {
  Attack answer;
  answer.status = std::move(status);
  return answer;
}

}  // namespace forge
