#include "collision_forge/ros/injection/agent_body.h"

#include <stdexcept>

#include "collision_forge/base/scene/track.h"

namespace forge {

Eigen::Isometry3d bottomOf(const collision_forge::Agent& agent) {
  const auto& [x, y, z, w] = agent.pose.orientation;
  const auto& position = agent.pose.position;
  return Eigen::Translation3d(position.x, position.y, position.z) *
         Eigen::Quaterniond(w, x, y, z).normalized() *
         Eigen::Translation3d(0.0, 0.0, -agent.size.z / 2.0);
}

Eigen::Vector3d sizeOf(const collision_forge::Agent& agent) {
  const auto& [length, width, height] = agent.size;
  if (height != 0.0) return {length, width, height};
  return {length, width,
          typicalHeight(static_cast<AgentClass>(agent.agent_class), {length, width})};
}

AgentInSweep movingAgent(const collision_forge::Agent& agent, double begin_time) {
  AgentInSweep moving{agent, agent, begin_time, 0.0};
  moving.begin.pose.position.x += begin_time * agent.velocity.x;
  moving.begin.pose.position.y += begin_time * agent.velocity.y;
  return moving;
}

PosedBody bodyInCloud(const AgentInSweep& agent, const SensorInSweep& sensor,
                      const SweepRays& sweep, std::uint64_t seed) {
  const Eigen::Vector3d size = sizeOf(agent.end);
  PosedBody body;
  body.brightness = brightnessOf(agent.end.id, seed);
  body.begin = sensor.begin.inverse() * bottomOf(agent.begin);
  body.end = sensor.end.inverse() * bottomOf(agent.end);
  body.begin_time = agent.begin_time;
  body.end_time = agent.end_time;
  if (!(size.minCoeff() > 0.0) || !size.allFinite() || !body.begin.matrix().allFinite() ||
      !body.end.matrix().allFinite()) {
    throw std::invalid_argument("agent " + agent.end.id + " has no finite pose and size");
  }
  const Eigen::Translation3d ground(0.0, 0.0,
                                    groundBelow(sweep, body.end, size.head<2>()).value_or(0.0));
  body.begin = body.begin * ground;
  body.end = body.end * ground;
  // Legs swing with the distance along x and y in the map, which is continuous from sweep to sweep.
  const auto& position = agent.end.pose.position;
  body.body =
      lidarBodyOf(static_cast<AgentClass>(agent.end.agent_class), size, position.x + position.y);
  return body;
}

}  // namespace forge
