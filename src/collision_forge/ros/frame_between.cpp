#include "collision_forge/ros/frame_between.h"

#include <algorithm>

#include <Eigen/Geometry>

namespace forge {
namespace {

/// Of points and vectors.
template <typename Message>
Message between(const Message& before, const Message& after, double ratio) {
  Message message;
  message.x = before.x + ratio * (after.x - before.x);
  message.y = before.y + ratio * (after.y - before.y);
  message.z = before.z + ratio * (after.z - before.z);
  return message;
}

geometry_msgs::Quaternion turnedBetween(const geometry_msgs::Quaternion& before,
                                        const geometry_msgs::Quaternion& after, double ratio) {
  const Eigen::Quaterniond from(before.w, before.x, before.y, before.z);
  const Eigen::Quaterniond to(after.w, after.x, after.y, after.z);
  const Eigen::Quaterniond turned = from.slerp(ratio, to);
  geometry_msgs::Quaternion message;
  message.w = turned.w();
  message.x = turned.x();
  message.y = turned.y();
  message.z = turned.z();
  return message;
}

}  // namespace

collision_forge::AgentArray frameBetween(const collision_forge::AgentArray& before,
                                         const collision_forge::AgentArray& after, double ratio) {
  collision_forge::AgentArray frame;
  frame.header = before.header;
  frame.header.stamp += (after.header.stamp - before.header.stamp) * ratio;
  for (collision_forge::Agent agent : before.agents) {
    const auto then = std::find_if(after.agents.begin(), after.agents.end(),
                                   [&](const auto& other) { return other.id == agent.id; });
    if (then == after.agents.end()) continue;
    agent.pose.position = between(agent.pose.position, then->pose.position, ratio);
    agent.pose.orientation = turnedBetween(agent.pose.orientation, then->pose.orientation, ratio);
    agent.velocity = between(agent.velocity, then->velocity, ratio);
    frame.agents.push_back(agent);
  }
  return frame;
}

}  // namespace forge
