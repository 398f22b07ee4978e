#include "collision_forge/attack/forecast/kinematic_prediction.h"

#include <cmath>
#include <functional>

#include "collision_forge/attack/forecast/motion_estimate.h"

namespace forge {
namespace {

// m over which the lateral offset of a vehicle that follows a lane fades by 1/e.
constexpr double kLaneReturnDistance = 15.0;

Track trackFrom(const Track& past, double now, double horizon, double step,
                const std::function<Pose2(double)>& pose_after) {
  Track future{past.id, past.agent_class, past.size, {}, past.height};
  const int steps = static_cast<int>(std::ceil(horizon / step));
  future.states.reserve(static_cast<std::size_t>(steps) + 1);
  for (int i = 0; i <= steps; ++i) {
    future.states.push_back({now + i * step, pose_after(i * step), Vector2::Zero()});
  }
  deriveVelocities(future);
  return future;
}

Track followLane(const Track& past, double now, double horizon, const Motion& motion,
                 const Polyline& path) {
  const PolylineProjection start = path.project(motion.pose.position());
  const Pose2 offset = relativeTo(start.pose, motion.pose);
  return trackFrom(past, now, horizon, kPredictionStep, [=, &path](double t) {
    const double driven = motion.speed * t;
    const double fade = std::exp(-driven / kLaneReturnDistance);
    return compose(path.poseAt(start.arc_length + driven),
                   {offset.x * fade, offset.y * fade, offset.yaw * fade});
  });
}

Track predictTrack(const Track& past, const Snapshot& snapshot, const LaneIndex& lanes,
                   double horizon) {
  const Motion motion = estimateMotion(past);
  const double now = snapshot.now;
  const Vector2 velocity = past.states.back().velocity;
  const double speed = isVehicle(past.agent_class) ? std::abs(motion.speed) : velocity.norm();
  if (speed < kStandstillSpeed) {
    return trackFrom(past, now, horizon, kPredictionStep, [&](double) { return motion.pose; });
  }
  if (isVehicle(past.agent_class) && motion.speed > 0.0) {
    const auto matches = lanes.lanesNear(motion.pose, kOnLaneDistance, kOnLaneHeading);
    if (!matches.empty()) {
      const double reach = motion.speed * horizon + kLaneReturnDistance;
      const Polyline path =
          lanes.pathAhead(matches.front().lane, matches.front().projection.arc_length, reach);
      return followLane(past, now, horizon, motion, path);
    }
  }
  return trackFrom(past, now, horizon, kPredictionStep, [&](double t) {
    return Pose2{motion.pose.x + velocity.x() * t, motion.pose.y + velocity.y() * t,
                 motion.pose.yaw};
  });
}

}  // namespace

Future predictFuture(const Snapshot& snapshot, const LaneIndex& lanes, double horizon) {
  Future future;
  future.ego = predictTrack(snapshot.ego, snapshot, lanes, horizon);
  for (const Track& agent : snapshot.agents) {
    if (!endsAt(agent, snapshot.now)) continue;
    future.agents.push_back(predictTrack(agent, snapshot, lanes, horizon));
  }
  return future;
}

}  // namespace forge
