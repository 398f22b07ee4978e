#include "collision_forge/ros/injection/live_lidar.h"

#include <algorithm>
#include <set>
#include <utility>

#include "collision_forge/ros/injection/frame_between.h"
#include "collision_forge/ros/messages/cloud_message.h"
#include "collision_forge/ros/messages/posed_frames.h"

namespace forge {

void LiveLidar::keep(const collision_forge::AgentArray::ConstPtr& frame, Frames& frames) {
  constexpr std::size_t kFrames = 20;
  // A replay that steps back starts anew.
  if (!frames.empty() && frame->header.stamp < frames.back()->header.stamp) frames.clear();
  frames.push_back(frame);
  if (frames.size() > kFrames) frames.pop_front();
}

std::optional<collision_forge::Agent> LiveLidar::agentAt(const Frames& frames,
                                                         const std::string& id,
                                                         const ros::Time& stamp) {
  const auto agentIn =
      [&](const collision_forge::AgentArray& frame) -> std::optional<collision_forge::Agent> {
    for (const collision_forge::Agent& agent : frame.agents) {
      if (agent.id == id) return agent;
    }
    return std::nullopt;
  };
  const auto after = std::find_if(frames.begin(), frames.end(),
                                  [&](const auto& frame) { return frame->header.stamp >= stamp; });
  if (after == frames.end()) {
    if (frames.empty()) return std::nullopt;
    const double gap = (stamp - frames.back()->header.stamp).toSec();
    auto agent = agentIn(*frames.back());
    if (!agent || gap > kReach) return std::nullopt;
    agent->pose.position.x += gap * agent->velocity.x;
    agent->pose.position.y += gap * agent->velocity.y;
    return agent;
  }
  if ((*after)->header.stamp == stamp) return agentIn(**after);
  if (after == frames.begin()) return std::nullopt;
  const collision_forge::AgentArray& before = **std::prev(after);
  const double gap = ((*after)->header.stamp - before.header.stamp).toSec();
  return agentIn(frameBetween(before, **after, (stamp - before.header.stamp).toSec() / gap));
}

bool LiveLidar::edit(const SensorInSweep& sensor, sensor_msgs::PointCloud2& message) const {
  const ros::Time stamp = message.header.stamp;
  std::set<std::string> ids;
  if (!attacker_.empty()) ids.insert(attacker_);
  if (shows_all_ && !injected_.empty()) {
    for (const collision_forge::Agent& agent : injected_.back()->agents) ids.insert(agent.id);
  }
  std::vector<AgentInSweep> shown;
  for (const std::string& id : ids) {
    const auto agent = agentAt(injected_, id, stamp);
    if (!agent) continue;
    shown.push_back(movingAgent(*agent, -options_.sweep_time));
  }
  if (shown.empty()) return false;
  const auto vacated = agentAt(recorded_, attacker_, stamp);
  sensor_msgs::PointCloud2 original = message;
  PointCloud cloud = takeCloud(original);
  const CloudLayout layout(cloud);
  const SweepRays sweep = raysOf(cloud, layout, {stamp.toSec(), options_.sweep_time});
  CloudEdit edit;
  edit.range_noise = options_.range_noise;
  edit.seed = stamp.toNSec();
  for (const AgentInSweep& agent : shown) edit.bodies.push_back(bodyInCloud(agent, sensor, sweep));
  if (vacated) {
    edit.vacated.push_back(
        vacatedBoxOf(bodyInCloud(movingAgent(*vacated, -options_.sweep_time), sensor, sweep)));
  }
  editCloud(cloud, layout, sweep, edit, surfaces_);
  putCloud(std::move(cloud), message);
  return true;
}

}  // namespace forge
