#include "collision_forge/ros/messages/paths.h"

#include "collision_forge/ros/messages/conversions.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {
namespace {

template <typename States>
nav_msgs::Path pathOf(const States& states) {
  nav_msgs::Path path;
  path.header.frame_id = names::kMapFrame;
  for (const auto& state : states) {
    geometry_msgs::PoseStamped pose;
    pose.header.frame_id = names::kMapFrame;
    pose.header.stamp = stampOf(state.time);
    pose.pose = toPoseMessage(state.pose);
    path.poses.push_back(pose);
  }
  if (!path.poses.empty()) path.header.stamp = path.poses.front().header.stamp;
  return path;
}

}  // namespace

nav_msgs::Path toPath(const std::vector<TrajectoryPoint>& points) { return pathOf(points); }

nav_msgs::Path toPath(const Track& track, double begin, double end) {
  std::vector<AgentState> states;
  if (const auto first = stateAt(track, begin)) states.push_back(*first);
  for (const AgentState& state : track.states) {
    if (state.time > begin && state.time < end) states.push_back(state);
  }
  if (const auto last = stateAt(track, end)) states.push_back(*last);
  return pathOf(states);
}

}  // namespace forge
