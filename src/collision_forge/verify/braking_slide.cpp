#include "collision_forge/verify/braking_slide.h"

#include <algorithm>

namespace forge {
namespace {

double brakingOf(AgentClass agent_class, const BoxSize& size, const DriveLimitOptions& options) {
  return driveLimitsOf(agent_class, size, options).max_braking;
}

double areaOf(const BoxSize& size) { return size.length * size.width; }

}  // namespace

AgentState BrakingSlide::stateFrom(const Pose2& pose, double time) const {
  const double speed = velocity.norm();
  if (speed == 0.0) return {time, pose, velocity};
  const double duration = std::min(time - begin, speed / braking);
  const Vector2 direction = velocity / speed;
  const double way = speed * duration - braking * duration * duration / 2.0;
  const Vector2 position = pose.position() + way * direction;
  return {time, {position.x(), position.y(), pose.yaw}, (speed - braking * duration) * direction};
}

BrakingSlide slideFromEnd(const AttackerTrajectory& trajectory, const DriveLimitOptions& options) {
  const TrajectoryPoint& end = trajectory.points.back();
  return {end.time, end.speed * end.pose.heading(),
          brakingOf(trajectory.agent_class, trajectory.size, options)};
}

BrakingSlide slideFromContact(double contact_time, const AttackerTrajectory& trajectory,
                              const Track& ego, const DriveLimitOptions& options) {
  const Track attacker{trajectory.attacker_id, trajectory.agent_class, trajectory.size,
                       toStates(trajectory.points)};
  const auto velocityOf = [&](const Track& track) -> Vector2 {
    return stateAt(track, contact_time).value().velocity;
  };
  const double ego_share = areaOf(ego.size) / (areaOf(ego.size) + areaOf(attacker.size));
  return {contact_time, ego_share * velocityOf(ego) + (1.0 - ego_share) * velocityOf(attacker),
          std::min(brakingOf(ego.agent_class, ego.size, options),
                   brakingOf(attacker.agent_class, attacker.size, options))};
}

}  // namespace forge
