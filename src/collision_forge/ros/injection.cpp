#include "collision_forge/ros/injection.h"

#include <rosbag/view.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "collision_forge/ros/bag_file.h"
#include "collision_forge/ros/conversions.h"
#include "collision_forge/ros/markers.h"
#include "collision_forge/ros/topic_names.h"

namespace forge {
namespace {

/// The point of the trajectory at a time within it, interpolated.
TrajectoryPoint pointAt(const AttackerTrajectory& trajectory, double time) {
  const auto after = std::find_if(trajectory.points.begin(), trajectory.points.end(),
                                  [=](const TrajectoryPoint& point) { return point.time >= time; });
  if (after == trajectory.points.begin()) return trajectory.points.front();
  if (after == trajectory.points.end()) return trajectory.points.back();
  const TrajectoryPoint& before = *std::prev(after);
  const double ratio = (time - before.time) / (after->time - before.time);
  TrajectoryPoint point = *after;
  point.time = time;
  point.pose = interpolate(before.pose, after->pose, ratio);
  point.speed = before.speed + ratio * (after->speed - before.speed);
  return point;
}

/// Every frame of agents with the attack in it, by the time at which it was recorded.
std::map<ros::Time, collision_forge::AgentArray> injectedFrames(
    const rosbag::Bag& bag, const collision_forge::AttackerTrajectory& trajectory) {
  AttackerInjector injector(trajectory);
  std::map<ros::Time, collision_forge::AgentArray> frames;
  const rosbag::TopicQuery topic(bagTopic(names::kAgents));
  for (const rosbag::MessageInstance& instance : rosbag::View(bag, topic)) {
    if (const auto agents = instance.instantiate<collision_forge::AgentArray>()) {
      frames[instance.getTime()] = injector.inject(*agents);
    }
  }
  return frames;
}

}  // namespace

AttackerInjector::AttackerInjector(collision_forge::AttackerTrajectory trajectory)
    : trajectory_(std::move(trajectory)) {
  attacker_.id = trajectory_.attacker_id;
  attacker_.agent_class = trajectory_.agent_class;
  attacker_.size = trajectory_.size;
}

void AttackerInjector::remember(const collision_forge::AgentArray& recorded) {
  for (const collision_forge::Agent& agent : recorded.agents) {
    if (agent.id != attacker_.id) continue;
    attacker_ = agent;
    is_remembered_ = true;
  }
}

collision_forge::AgentArray AttackerInjector::inject(collision_forge::AgentArray agents) {
  auto& all = agents.agents;
  const auto recorded =
      std::find_if(all.begin(), all.end(),
                   [this](const collision_forge::Agent& a) { return a.id == attacker_.id; });
  if (trajectory_.points.empty() || agents.header.stamp <= trajectory_.points.front().stamp) {
    remember(agents);
    return agents;
  }
  if (agents.header.stamp > trajectory_.points.back().stamp) {
    if (recorded != all.end()) all.erase(recorded);
    return agents;
  }
  if (!is_remembered_) remember(agents);
  const TrajectoryPoint point = pointAt(fromMessage(trajectory_), agents.header.stamp.toSec());
  collision_forge::Agent attacker = attacker_;
  const double z = attacker_.pose.position.z;
  attacker.pose = toPoseMessage(point.pose);
  attacker.pose.position.z = z;
  const Vector2 velocity = point.speed * point.pose.heading();
  attacker.velocity.x = velocity.x();
  attacker.velocity.y = velocity.y();
  attacker.velocity.z = 0.0;
  if (recorded != all.end()) {
    *recorded = attacker;
  } else {
    all.push_back(attacker);
  }
  return agents;
}

void injectIntoBag(const std::string& in, const std::string& out,
                   const collision_forge::Attack& attack,
                   const collision_forge::CollisionReport& tested_report) {
  try {
    const rosbag::Bag source(in, rosbag::bagmode::Read);
    NewBag target(out);
    const ros::Time now = attack.trajectory.header.stamp;
    const auto frames = injectedFrames(source, attack.trajectory);
    bool added = false;
    const auto write_attack = [&] {
      target.writeLatched(bagTopic(names::kAttack), now, attack);
      target.writeLatched(bagTopic(names::kTestedReport), now, tested_report);
    };
    for (const rosbag::MessageInstance& instance : rosbag::View(source)) {
      const std::string& topic = instance.getTopic();
      const ros::Time time = instance.getTime();
      if (!added && time > now) {
        write_attack();
        added = true;
      }
      // Messages of the same time come in any order: markers may come before the agents they show.
      const auto after = frames.upper_bound(time);
      const auto frame = after == frames.begin() ? frames.end() : std::prev(after);
      if (time > now && frame != frames.end()) {
        if (topic == bagTopic(names::kAgents) && frame->first == time) {
          target.write(topic, time, frame->second, instance.getConnectionHeader());
          continue;
        }
        if (topic == bagTopic(names::kAnnotationMarkers)) {
          target.write(topic, time, annotationMarkers(frame->second),
                       instance.getConnectionHeader());
          continue;
        }
      }
      target.write(topic, time, instance, instance.getConnectionHeader());
    }
    if (!added) write_attack();
    target.commit();
  } catch (const rosbag::BagException& error) {
    throw BagError(in + " to " + out + ": " + error.what());
  }
}

}  // namespace forge
