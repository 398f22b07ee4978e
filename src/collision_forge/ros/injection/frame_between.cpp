#include "collision_forge/ros/injection/frame_between.h"

#include <algorithm>

#include <Eigen/Geometry>

#include "collision_forge/ros/markers/shown_motion.h"
#include "collision_forge/ros/messages/conversions.h"

namespace forge {
namespace {

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

/// Adds the agent of that id, if it is there, to its track.
void appendState(const collision_forge::AgentArray& frame, Track& track) {
  const auto agent = std::find_if(frame.agents.begin(), frame.agents.end(),
                                  [&](const auto& other) { return other.id == track.id; });
  if (agent == frame.agents.end()) return;
  track.states.push_back({frame.header.stamp.toSec(), fromMessage(agent->pose), Vector2::Zero()});
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

std::vector<collision_forge::Agent> agentsAt(const std::vector<collision_forge::AgentArray>& frames,
                                             const ros::Time& stamp) {
  const auto after = std::lower_bound(
      frames.begin(), frames.end(), stamp,
      [](const auto& frame, const ros::Time& time) { return frame.header.stamp < time; });
  if (after == frames.end()) return {};
  if (after->header.stamp == stamp) return after->agents;
  if (after == frames.begin()) return {};
  const auto before = std::prev(after);
  const double gap = (after->header.stamp - before->header.stamp).toSec();
  if (gap > kMaxGap) return {};
  return frameBetween(*before, *after, (stamp - before->header.stamp).toSec() / gap).agents;
}

collision_forge::AgentArray frameAfter(const collision_forge::AgentArray* before,
                                       const collision_forge::AgentArray& newest,
                                       const ros::Time& stamp) {
  collision_forge::AgentArray frame = newest;
  frame.header.stamp = stamp;
  for (collision_forge::Agent& agent : frame.agents) {
    Track track{agent.id, {}, {}, {}};
    if (before) appendState(*before, track);
    appendState(newest, track);
    deriveVelocities(track);
    const Pose2 pose = shownPose(toMessage(track), stamp);
    const double turn = angleBetween(track.states.back().pose.yaw, pose.yaw);
    const Vector2 velocity = Eigen::Rotation2Dd(turn) * Vector2(agent.velocity.x, agent.velocity.y);
    setPlanar(pose, agent.pose);
    agent.velocity.x = velocity.x();
    agent.velocity.y = velocity.y();
  }
  return frame;
}

}  // namespace forge
