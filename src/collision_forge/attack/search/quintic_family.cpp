#include <cmath>

#include "collision_forge/attack/search/quintic.h"
#include "collision_forge/attack/search/trajectory_family.h"

namespace forge {
namespace {

constexpr double kStandstill = 0.1;  // m/s; below, the direction of motion is no heading

/// The axes x and y of the map.
struct Axes {
  AxisState first;
  AxisState second;
};

Axes alongHeading(const Vector2& position, const Vector2& heading, double speed,
                  double acceleration) {
  return {{position.x(), speed * heading.x(), acceleration * heading.x()},
          {position.y(), speed * heading.y(), acceleration * heading.y()}};
}

void setPose(double time, const Vector2& position, const Vector2& velocity, double held_yaw,
             TrajectoryPoint& point) {
  point.time = time;
  point.speed = velocity.norm();
  const double yaw = point.speed > kStandstill ? std::atan2(velocity.y(), velocity.x()) : held_yaw;
  point.pose = {position.x(), position.y(), yaw};
}

/// Returns the turn per distance between two points, 1/m.
double curvatureBetween(double step, const TrajectoryPoint& a, const TrajectoryPoint& b) {
  const double way = (b.pose.position() - a.pose.position()).norm();
  return angleBetween(a.pose.yaw, b.pose.yaw) / std::max(way, kStandstill * step);
}

/// Derives the acceleration from neighbouring positions and the curvature from the sharper of the
/// two neighbouring turns, so that a reader of the positions finds the same values.
void deriveFromNeighbours(double step, std::vector<TrajectoryPoint>& points) {
  const std::size_t last = points.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    TrajectoryPoint& point = points[i];
    const TrajectoryPoint& before = points[i > 0 ? i - 1 : 0];
    const TrajectoryPoint& after = points[std::min(i + 1, last)];
    if (i == 0 || i == last) {
      point.acceleration = (after.speed - before.speed) / step;
    } else {
      const Vector2 change =
          after.pose.position() - 2.0 * point.pose.position() + before.pose.position();
      point.acceleration = change.dot(point.pose.heading()) / (step * step);
    }
    const double into = i > 0 ? curvatureBetween(step, before, point) : 0.0;
    const double out = i < last ? curvatureBetween(step, point, after) : 0.0;
    point.curvature = std::abs(into) > std::abs(out) ? into : out;
  }
}

}  // namespace

void driveQuintic(const DriveStart& start, const Arrival& arrival,
                  std::vector<TrajectoryPoint>& points) {
  const Motion& motion = start.motion;
  const Axes from = alongHeading(motion.pose.position(), motion.pose.heading(), motion.speed,
                                 arrival.start_acceleration);
  const Axes to = alongHeading(arrival.pose.position(), arrival.pose.heading(), arrival.speed,
                               arrival.end_acceleration);
  const Quintic first(from.first, to.first, arrival.time);
  const Quintic second(from.second, to.second, arrival.time);
  points.resize(static_cast<std::size_t>(start.points));
  double yaw = motion.pose.yaw;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double t = static_cast<double>(i) * start.step;
    if (t >= arrival.time) {
      const Pose2 pose = compose(arrival.pose, {(t - arrival.time) * arrival.speed, 0.0, 0.0});
      points[i] = {start.now + t, pose, arrival.speed, 0.0, 0.0};
      continue;
    }
    const Axes state{first.at(t), second.at(t)};
    setPose(start.now + t, {state.first.position, state.second.position},
            {state.first.velocity, state.second.velocity}, yaw, points[i]);
    yaw = points[i].pose.yaw;
  }
  deriveFromNeighbours(start.step, points);
}

}  // namespace forge
