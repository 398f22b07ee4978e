#include "collision_forge/attack/verify/braking_slide.h"

#include <algorithm>

namespace forge {

AgentState StraightBraking::stateFrom(const Pose2& pose, double time) const {
  const double speed = velocity.norm();
  if (speed == 0.0) return {time, pose, velocity};
  const double duration = std::min(time - begin, speed / braking);
  const Vector2 direction = velocity / speed;
  const double way = speed * duration - braking * duration * duration / 2.0;
  const Vector2 position = pose.position() + way * direction;
  return {time, {position.x(), position.y(), pose.yaw}, (speed - braking * duration) * direction};
}

double StraightBraking::standTime() const {
  const double speed = velocity.norm();
  return speed == 0.0 ? begin : begin + speed / braking;
}

StraightBraking brakingFromEnd(const AttackerTrajectory& trajectory,
                               const DriveLimitOptions& options) {
  const TrajectoryPoint& end = trajectory.points.back();
  const DriveLimits limits = driveLimitsOf(trajectory.agent_class, trajectory.size, options);
  return {end.time, end.speed * end.pose.heading(), limits.max_braking};
}

}  // namespace forge
