#include "collision_forge/ros/bags/bag_writer.h"

#include <nav_msgs/Odometry.h>
#include <tf2_msgs/TFMessage.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <limits>
#include <set>

#include "collision_forge/ros/bags/bag_file.h"
#include "collision_forge/ros/markers/markers.h"
#include "collision_forge/ros/messages/conversions.h"
#include "collision_forge/ros/messages/object_array.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {
namespace {

ros::Time toTime(std::int64_t timestamp_us) {
  return ros::Time().fromNSec(static_cast<std::uint64_t>(timestamp_us) * 1000U);
}

template <typename Vector>
Vector toVector(const Eigen::Vector3d& value) {
  Vector message;
  message.x = value.x();
  message.y = value.y();
  message.z = value.z();
  return message;
}

geometry_msgs::Quaternion toQuaternion(const Eigen::Quaterniond& rotation) {
  const Eigen::Quaterniond unit = rotation.normalized();
  geometry_msgs::Quaternion message;
  message.w = unit.w();
  message.x = unit.x();
  message.y = unit.y();
  message.z = unit.z();
  return message;
}

tf2_msgs::TFMessage toTransform(const NuScenesEgoPose& pose) {
  geometry_msgs::TransformStamped transform;
  transform.header.stamp = toTime(pose.timestamp_us);
  transform.header.frame_id = names::kMapFrame;
  transform.child_frame_id = names::kBaseFrame;
  transform.transform.translation = toVector<geometry_msgs::Vector3>(pose.translation);
  transform.transform.rotation = toQuaternion(pose.rotation);
  tf2_msgs::TFMessage message;
  message.transforms.push_back(transform);
  return message;
}

/// Twist in base_link from the neighbouring poses (REP-105, nav_msgs/Odometry).
nav_msgs::Odometry toOdometry(const std::vector<NuScenesEgoPose>& poses, std::size_t index) {
  const NuScenesEgoPose& pose = poses[index];
  const NuScenesEgoPose& before = poses[index > 0 ? index - 1 : index];
  const NuScenesEgoPose& after = poses[std::min(index + 1, poses.size() - 1)];
  nav_msgs::Odometry message;
  message.header.stamp = toTime(pose.timestamp_us);
  message.header.frame_id = names::kMapFrame;
  message.child_frame_id = names::kBaseFrame;
  message.pose.pose.position = toVector<geometry_msgs::Point>(pose.translation);
  message.pose.pose.orientation = toQuaternion(pose.rotation);
  const double duration = static_cast<double>(after.timestamp_us - before.timestamp_us) * 1e-6;
  if (duration > 0.0) {
    const Eigen::Vector3d velocity = (after.translation - before.translation) / duration;
    message.twist.twist.linear =
        toVector<geometry_msgs::Vector3>(pose.rotation.normalized().inverse() * velocity);
    message.twist.twist.angular.z =
        angleBetween(yawOf(before.rotation), yawOf(after.rotation)) / duration;
  }
  return message;
}

collision_forge::AgentArray toAgents(const NuScenesFrame& frame) {
  collision_forge::AgentArray message;
  message.header.stamp = toTime(frame.timestamp_us);
  message.header.frame_id = names::kMapFrame;
  for (const NuScenesAnnotation& annotation : frame.annotations) {
    collision_forge::Agent agent;
    agent.id = annotation.instance;
    agent.agent_class = static_cast<std::uint8_t>(
        agentClassOfCategory(annotation.category).value_or(AgentClass::kStaticObject));
    agent.size = toVector<geometry_msgs::Vector3>(annotation.size);
    agent.pose.position = toVector<geometry_msgs::Point>(annotation.translation);
    agent.pose.orientation = toQuaternion(annotation.rotation);
    agent.velocity = toVector<geometry_msgs::Vector3>(annotation.velocity);
    message.agents.push_back(std::move(agent));
  }
  return message;
}

/// Returns the times at which a light changes, s, ascending.
std::set<double> changesOf(const std::vector<TrafficLight>& lights) {
  std::set<double> times;
  for (const TrafficLight& light : lights) {
    for (const LightState& state : light.states) times.insert(state.time);
  }
  return times;
}

}  // namespace

SensorCounts writeBag(const std::string& path, const NuScenesRecording& recording,
                      const LaneMap& map, const NuScenesSensorScene* sensors,
                      const std::function<void(NewBag&)>& write_more) {
  if (recording.ego_poses.empty() || recording.frames.empty()) {
    throw BagError(path + ": scene " + recording.name + " has no ego poses or no frames");
  }
  NewBag bag(path);
  const ros::Time start = toTime(
      std::min(recording.ego_poses.front().timestamp_us, recording.frames.front().timestamp_us));
  bag.writeLatched(bagTopic(names::kLaneMap), start, toMessage(map, start));
  if (recording.ego_size) {
    collision_forge::EgoVehicle ego;
    ego.length = recording.ego_size->length;
    ego.width = recording.ego_size->width;
    bag.writeLatched(bagTopic(names::kEgoVehicle), start, ego);
  }
  for (const double time : changesOf(recording.lights)) {
    const ros::Time stamp = std::max(start, stampOf(time));
    const collision_forge::TrafficLightArray lights = toMessage(recording.lights, stamp);
    bag.writeLatched(bagTopic(names::kTrafficLights), stamp, lights);
    bag.writeLatched(bagTopic(names::kLightMarkers), stamp, lightMarkers(lights));
  }
  const NuScenesSensorScene none;
  SensorWriter sensor_writer(sensors ? *sensors : none, recording, bag);
  if (sensors) sensor_writer.writeMounting(start);
  auto frame = recording.frames.begin();
  const auto writeFramesUpTo = [&](std::int64_t timestamp_us) {
    for (; frame != recording.frames.end() && frame->timestamp_us <= timestamp_us; ++frame) {
      const collision_forge::AgentArray agents = toAgents(*frame);
      bag.write(bagTopic(names::kAgents), agents.header.stamp, agents);
      bag.write(bagTopic(names::kAnnotationMarkers), agents.header.stamp,
                annotationMarkers(agents));
      bag.write(bagTopic(names::kAgentObjects), agents.header.stamp, toObjects(agents));
    }
  };
  for (std::size_t i = 0; i < recording.ego_poses.size(); ++i) {
    const ros::Time stamp = toTime(recording.ego_poses[i].timestamp_us);
    bag.write(names::kTf, stamp, toTransform(recording.ego_poses[i]));
    bag.write(bagTopic(names::kOdometry), stamp, toOdometry(recording.ego_poses, i));
    writeFramesUpTo(recording.ego_poses[i].timestamp_us);
    sensor_writer.writeUpTo(recording.ego_poses[i].timestamp_us);
  }
  writeFramesUpTo(recording.frames.back().timestamp_us);
  sensor_writer.writeUpTo(std::numeric_limits<std::int64_t>::max());
  if (write_more) write_more(bag);
  bag.commit();
  return sensor_writer.counts();
}

}  // namespace forge
