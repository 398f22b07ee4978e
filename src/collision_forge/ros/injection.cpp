#include "collision_forge/ros/injection.h"

#include <rosbag/view.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

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

/// Where an attacker that was added was at a time in its past; empty beyond it.
std::optional<AgentState> pastAt(const collision_forge::AttackerTrajectory& trajectory,
                                 double time) {
  Track past;
  for (const auto& state : trajectory.past) past.states.push_back(fromMessage(state));
  return stateAt(past, time);
}

/// From when on a bag is another with the attack in it.
bool isChangedAt(const ros::Time& time, const collision_forge::AttackerTrajectory& trajectory) {
  if (!trajectory.past.empty()) return time >= trajectory.past.front().stamp;
  return time > trajectory.header.stamp;
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

bool AttackerInjector::change(const collision_forge::AttackerTrajectory& trajectory) {
  const bool is_same = trajectory.attacker_id == trajectory_.attacker_id &&
                       trajectory.header.stamp == trajectory_.header.stamp &&
                       trajectory.agent_class == trajectory_.agent_class &&
                       trajectory.size == trajectory_.size && trajectory.past == trajectory_.past;
  if (is_same) trajectory_ = trajectory;
  return is_same;
}

void AttackerInjector::remember(const collision_forge::AgentArray& recorded) {
  for (const collision_forge::Agent& agent : recorded.agents) {
    if (agent.id != attacker_.id) continue;
    attacker_ = agent;
    is_remembered_ = true;
  }
  if (!trajectory_.past.empty() && !is_remembered_) rememberLike(recorded);
}

/// Takes height and z from the vehicle that is most like an attacker that was added.
void AttackerInjector::rememberLike(const collision_forge::AgentArray& recorded) {
  const auto unlike = [this](const collision_forge::Agent& agent) {
    const Pose2 now = forge::fromMessage(trajectory_.past.back().pose);
    const double distance = (forge::fromMessage(agent.pose).position() - now.position()).norm();
    return std::pair(agent.agent_class != attacker_.agent_class, distance);
  };
  const collision_forge::Agent* most_like = nullptr;
  for (const collision_forge::Agent& agent : recorded.agents) {
    const bool is_vehicle = agent.agent_class <= collision_forge::Agent::STATIC_OBJECT &&
                            canAttack(static_cast<AgentClass>(agent.agent_class));
    if (is_vehicle && (!most_like || unlike(agent) < unlike(*most_like))) most_like = &agent;
  }
  if (!most_like) return;
  attacker_.size.z = most_like->size.z;
  attacker_.pose.position.z = most_like->pose.position.z;
  is_remembered_ = true;
}

/// In place of the recorded attacker, if it is there.
void AttackerInjector::put(const Pose2& pose, const Vector2& velocity,
                           collision_forge::AgentArray& agents) const {
  collision_forge::Agent attacker = attacker_;
  attacker.pose = toPoseMessage(pose);
  attacker.pose.position.z = attacker_.pose.position.z;
  attacker.velocity.x = velocity.x();
  attacker.velocity.y = velocity.y();
  attacker.velocity.z = 0.0;
  for (collision_forge::Agent& agent : agents.agents) {
    if (agent.id != attacker.id) continue;
    agent = attacker;
    return;
  }
  agents.agents.push_back(attacker);
}

collision_forge::AgentArray AttackerInjector::inject(collision_forge::AgentArray agents) {
  auto& all = agents.agents;
  const auto recorded =
      std::find_if(all.begin(), all.end(),
                   [this](const collision_forge::Agent& a) { return a.id == attacker_.id; });
  if (trajectory_.points.empty() || agents.header.stamp <= trajectory_.points.front().stamp) {
    remember(agents);
    const auto before = pastAt(trajectory_, agents.header.stamp.toSec());
    if (before) put(before->pose, before->velocity, agents);
    return agents;
  }
  if (agents.header.stamp > trajectory_.points.back().stamp) {
    if (recorded != all.end()) all.erase(recorded);
    return agents;
  }
  if (!is_remembered_) remember(agents);
  const TrajectoryPoint point = pointAt(fromMessage(trajectory_), agents.header.stamp.toSec());
  put(point.pose, point.speed * point.pose.heading(), agents);
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
      if (frame != frames.end() && isChangedAt(time, attack.trajectory)) {
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
