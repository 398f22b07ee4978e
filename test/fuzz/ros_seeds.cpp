#include <collision_forge/AttackRequest.h>
#include <collision_forge/GenerateCollision.h>
#include <collision_forge/GenerateCollisions.h>
#include <collision_forge/ListCollisions.h>
#include <collision_forge/PlannedTrajectory.h>
#include <collision_forge/PredictPattern.h>
#include <collision_forge/RealizeTrajectory.h>
#include <collision_forge/TestPlanner.h>
#include <nav_msgs/Odometry.h>
#include <rosbag/bag.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_msgs/TFMessage.h>

#include "attack/search/test_scenes.h"
#include "collision_forge/io/lidar/simulated_sweep.h"
#include "collision_forge/ros/bags/bag_file.h"
#include "collision_forge/ros/messages/attack_request.h"
#include "collision_forge/ros/messages/cloud_message.h"
#include "collision_forge/ros/messages/conversions.h"
#include "collision_forge/ros/messages/object_array.h"
#include "collision_forge/ros/messages/ros_bytes.h"
#include "collision_forge/ros/messages/topic_names.h"
#include "fuzz/embedded_seeds.h"
#include "fuzz/reading.h"
#include "fuzz/targets.h"

namespace forge {
namespace {

Snapshot busyRoad() {
  return snapshotOf(pastTrack(kEgoId, kEgoSize, {}, 8.0),
                    {pastTrack("ahead", kCarSize, {25.0, 0.0, 0.0}, 6.0),
                     pastTrack("behind", kCarSize, {-25.0, 0.0, 0.0}, 9.0)},
                    emptyMap());
}

collision_forge::LaneMap laneMap() {
  LaneMap map;
  map.location = "embedded-right";
  map.lanes = {straightLane("east", {-30.0, 0.0}, {60.0, 0.0}, {"on"}),
               straightLane("on", {60.0, 0.0}, {90.0, 0.0})};
  map.drivable_area = {rectangle(-30.0, -1.75, 90.0, 1.75)};
  return toMessage(map, stampOf(kNow));
}

collision_forge::AgentArray agentsAtNow() {
  collision_forge::AgentArray message;
  message.header.stamp = stampOf(kNow);
  message.header.frame_id = names::kMapFrame;
  for (const Track& track : busyRoad().agents) {
    collision_forge::Agent agent;
    agent.id = track.id;
    agent.pose = toPoseMessage(track.states.back().pose);
    agent.size = toMessage(track.size);
    message.agents.push_back(agent);
  }
  return message;
}

tf2_msgs::TFMessage egoAt(double time) {
  tf2_msgs::TFMessage message;
  message.transforms.emplace_back();
  auto& transform = message.transforms.back();
  transform.header.stamp = stampOf(time);
  transform.header.frame_id = names::kMapFrame;
  transform.child_frame_id = names::kBaseFrame;
  transform.transform.rotation.w = 1.0;
  return message;
}

nav_msgs::Odometry odometry() {
  nav_msgs::Odometry message;
  message.header.stamp = stampOf(kNow);
  message.header.frame_id = names::kMapFrame;
  message.pose.pose.orientation.w = 1.0;
  return message;
}

Attack answer() {
  Attack found;
  found.pattern = {CollisionType::kRearEnd,      "attacker",          kNow + 2.0,
                   {{16.0, 0.0, 0.0}, kEgoSize}, {-4.3, 0.25, 0.125}, 12.5};
  found.trajectory = straightDrive({-14.7, 0.0, 0.0}, 10.0, 2.0);
  found.report.contact = true;
  found.report.contact_time = kNow + 1.9;
  return found;
}

collision_forge::Attack attack() { return toMessage(answer(), "search", kNow); }

collision_forge::CollisionRequest request() {
  return toMessage(believableRequestFor(CollisionType::kLtap));
}

Future future() {
  return {futureTrack(kEgoId, kEgoSize, {}, 8.0),
          {futureTrack("ahead", kCarSize, {25.0, 0.0, 0.0}, 6.0)},
          {}};
}

/// Returns a line with the message's type, then its bytes.
template <typename Message>
std::string told(const std::string& type, const Message& message) {
  std::string bytes = type + "\n";
  appendRosBytes(bytes, message);
  return bytes;
}

std::string generateSeed() {
  collision_forge::GenerateCollision::Request message;
  message.collision_type = "lane_change";
  message.tta = 3.5;
  message.manoeuvre = "cut_in";
  message.max_impact_speed = 9.0;
  message.adaptive = 1;
  return told("GenerateCollision", message);
}

template <typename Asked>
Asked eachOf() {
  Asked message;
  message.collision_types = {"ltap", "rear_end"};
  message.ttas = {2.0, 4.0};
  message.request.mode = "history";
  return message;
}

std::string predictSeed() {
  collision_forge::PredictPattern::Request message;
  message.scene = toMessage(busyRoad());
  message.request = request();
  message.recorded_future = toMessage(future());
  return told("PredictPattern", message);
}

collision_forge::RealizeTrajectory::Request realizeRequest() {
  collision_forge::RealizeTrajectory::Request message;
  message.scene = toMessage(busyRoad());
  message.request = request();
  CollisionPattern pattern = answer().pattern;
  pattern.attacker_id = "behind";
  message.patterns = {toMessage(pattern, kNow)};
  message.future = toMessage(future());
  return message;
}

std::string testSeed() {
  collision_forge::TestPlanner::Request message;
  message.trajectory = toMessage(answer().trajectory);
  message.collision_type = "rear_end";
  message.planner = "pdm";
  message.parameters.emplace_back();
  message.parameters.back().name = "pdm.idm.min_gap";
  message.parameters.back().value = 1.5;
  return told("TestPlanner", message);
}

/// Returns the bytes of a bag with uncompressed chunks; `write` adds the messages.
template <typename Write>
std::string bagBy(const Write& write) {
  const InputFolder folder;
  const std::string path = folder.path() + "/seed.bag";
  {
    rosbag::Bag bag(path, rosbag::bagmode::Write);
    write(bag);
  }
  return bytesOf(path);
}

void writeScene(rosbag::Bag& bag) {
  const ros::Time now = stampOf(kNow);
  bag.write(names::kTf, now, egoAt(kNow - 0.5));
  bag.write(names::kTf, now, egoAt(kNow));
  bag.write(bagTopic(names::kAgents), now, agentsAtNow());
  bag.write(bagTopic(names::kLaneMap), now, laneMap());
}

void writeAttack(rosbag::Bag& bag) {
  const ros::Time now = stampOf(kNow);
  bag.write(bagTopic(names::kAttack), now, attack());
  bag.write(
      bagTopic(names::kAttackRequest), now,
      attackRequest(believableRequestFor(CollisionType::kRearEnd), attack(), "fingerprint", 1));
}

void writeForeign(rosbag::Bag& bag) {
  const ros::Time now = stampOf(kNow);
  bag.write("/odom", now, odometry());
  bag.write("/objects", now, toObjects(agentsAtNow()));
  tf2_msgs::TFMessage world = egoAt(kNow);
  world.transforms.front().header.frame_id = "world";
  world.transforms.front().child_frame_id = names::kMapFrame;
  bag.write("/tf_static", now, world);
  bag.write("/tf", now, egoAt(kNow));
}

}  // namespace

std::vector<std::string> bagSeeds() {
  const auto packed = [](rosbag::Bag& bag) {
    bag.setCompression(rosbag::compression::LZ4);
    writeScene(bag);
  };
  return {bagBy(writeScene), bagBy(writeAttack), bagBy(writeForeign), bagBy(packed), embeddedBag()};
}

std::vector<std::string> cloudSeeds() {
  SimulatedLidar lidar;
  lidar.columns = 24;
  sensor_msgs::PointCloud2 message;
  message.header.stamp = stampOf(kNow);
  putCloud(simulateSweep({}, Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, -1.8)), lidar, 0),
           message);
  std::string bytes;
  appendRosBytes(bytes, message);
  return {bytes};
}

std::vector<std::string> messageSeeds() {
  collision_forge::EncodedScene scene;
  scene.snapshot = toMessage(busyRoad());
  const auto asked = attackRequest(believableRequestFor(CollisionType::kRearEnd), attack(), "f", 1);
  collision_forge::PlannedTrajectory planned;
  planned.points = attack().trajectory.points;
  return {told("AgentArray", agentsAtNow()),
          told("Attack", attack()),
          told("AttackRequest", asked),
          told("EncodedScene", scene),
          generateSeed(),
          told("GenerateCollisions", eachOf<collision_forge::GenerateCollisions::Request>()),
          told("LaneMap", laneMap()),
          told("ListCollisions", eachOf<collision_forge::ListCollisions::Request>()),
          told("Odometry", odometry()),
          told("PlannedTrajectory", planned),
          predictSeed(),
          told("RealizeTrajectory", realizeRequest()),
          told("TFMessage", egoAt(kNow)),
          testSeed()};
}

std::vector<std::string> realizeSeeds() {
  collision_forge::RealizeTrajectory::Request known = realizeRequest();
  known.request = toMessage(believableRequestFor(CollisionType::kRearEnd));
  collision_forge::RealizeTrajectory::Request sampled = known;
  for (const double speed : {6.0, 8.0, 10.0, 12.0}) {
    sampled.future.ego_samples.push_back(toMessage(futureTrack(kEgoId, kEgoSize, {}, speed)));
  }
  collision_forge::RealizeTrajectory::Request strict = sampled;
  strict.request.believable = "false";
  strict.request.limits = "strict";
  strict.exact = 1;
  std::vector<std::string> seeds;
  for (const auto& message : {known, sampled, strict}) {
    appendRosBytes(seeds.emplace_back(), message);
  }
  return seeds;
}

}  // namespace forge
