#include "attack/quintic_join.h"

#include <cmath>

#include "attack/quintic.h"

namespace forge {
namespace {

constexpr double kStandstill = 0.1;  // m/s; below it the direction of motion is not a heading

struct PlaneState {
  AxisState x;
  AxisState y;
};

PlaneState planeState(const Pose2& pose, const Vector2& velocity, const Vector2& acceleration) {
  return {{pose.x, velocity.x(), acceleration.x()}, {pose.y, velocity.y(), acceleration.y()}};
}

/// `held_yaw` is kept while the vehicle stands.
TrajectoryPoint pointFrom(double time, const PlaneState& state, double held_yaw) {
  const Vector2 velocity(state.x.velocity, state.y.velocity);
  const Vector2 acceleration(state.x.acceleration, state.y.acceleration);
  const double speed = velocity.norm();
  TrajectoryPoint point;
  point.time = time;
  point.pose = {state.x.position, state.y.position, held_yaw};
  if (speed > kStandstill) {
    point.pose.yaw = std::atan2(velocity.y(), velocity.x());
    point.speed = speed;
    point.acceleration = velocity.dot(acceleration) / speed;
    point.curvature = (velocity.x() * acceleration.y() - velocity.y() * acceleration.x()) /
                      (speed * speed * speed);
  } else {
    const Vector2 heading = point.pose.heading();
    point.speed = heading.dot(velocity);
    point.acceleration = heading.dot(acceleration);
  }
  return point;
}

}  // namespace

AttackerTrajectory joinByQuintic(const Track& attacker, const Motion& motion, double now,
                                 const CollisionPattern& pattern,
                                 const RealizationOptions& options) {
  const Vector2 heading = motion.pose.heading();
  const Vector2 left(-heading.y(), heading.x());
  const PlaneState start =
      planeState(motion.pose, motion.speed * heading,
                 motion.acceleration * heading + motion.speed * motion.yaw_rate * left);
  const Pose2 target = compose(pattern.ego.center, pattern.attacker_offset);
  const Vector2 end_velocity = pattern.attacker_speed * target.heading();
  const PlaneState end = planeState(target, end_velocity, Vector2::Zero());
  const double duration = pattern.time - now;
  const Quintic x(start.x, end.x, duration);
  const Quintic y(start.y, end.y, duration);

  AttackerTrajectory trajectory{attacker.id, attacker.agent_class, attacker.size, {}};
  const int steps = static_cast<int>(std::lround((duration + options.tail) / options.step));
  trajectory.points.reserve(static_cast<std::size_t>(steps) + 1);
  double yaw = motion.pose.yaw;
  for (int i = 0; i <= steps; ++i) {
    const double t = i * options.step;
    PlaneState state = end;
    if (t < duration) {
      state = {x.at(t), y.at(t)};
    } else {
      state.x.position += (t - duration) * end_velocity.x();
      state.y.position += (t - duration) * end_velocity.y();
      yaw = target.yaw;
    }
    trajectory.points.push_back(pointFrom(now + t, state, yaw));
    yaw = trajectory.points.back().pose.yaw;
  }
  return trajectory;
}

}  // namespace forge
