#include "collision_forge/ros/injection/lidar_injection.h"

#include <rosbag/view.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <utility>

#include "collision_forge/ros/bags/bag_error.h"
#include "collision_forge/ros/bags/bag_file.h"
#include "collision_forge/ros/injection/frame_between.h"
#include "collision_forge/ros/messages/cloud_message.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {
namespace {

constexpr std::size_t kClouds = 40;   // per topic, from which returns are learnt
constexpr double kLearnReach = 60.0;  // m, of vehicles to learn from

bool isCloud(const rosbag::ConnectionInfo& connection) {
  return connection.datatype == ros::message_traits::datatype<sensor_msgs::PointCloud2>();
}

/// Returns true for the returns of a radar, which are clouds, too: they have a radar cross-section
/// or a Doppler speed.
bool isOfRadar(const rosbag::Bag& source, const std::string& topic) {
  rosbag::View view(source, rosbag::TopicQuery(topic));
  if (view.size() == 0) return false;
  const auto message = view.begin()->instantiate<sensor_msgs::PointCloud2>();
  return message && std::any_of(message->fields.begin(), message->fields.end(), [](auto& field) {
           std::string name = field.name;
           std::transform(name.begin(), name.end(), name.begin(),
                          [](unsigned char letter) { return std::tolower(letter); });
           return name == "rcs" || name.rfind("doppler", 0) == 0;
         });
}

std::string counted(std::size_t count, std::size_t of, const char* what) {
  return std::to_string(count) + " of " + std::to_string(of) + " " + what;
}

/// Returns true for an agent with a box that shows where its returns are: the size is positive, the
/// pose and the velocity are finite, and the quaternion is not zero.
bool hasKnownBox(const collision_forge::Agent& agent) {
  const auto& [x, y, z, w] = agent.pose.orientation;
  const Eigen::Vector3d size(agent.size.x, agent.size.y, agent.size.z);
  return size.allFinite() && size.minCoeff() > 0.0 && Eigen::Vector4d(x, y, z, w).norm() > 0.0 &&
         bottomOf(agent).matrix().allFinite() &&
         Eigen::Vector2d(agent.velocity.x, agent.velocity.y).allFinite();
}

/// Returns the earliest time of a ray, s after the stamp, at most 0.
double beginOf(const SweepRays& sweep) {
  double begin = 0.0;
  for (const LidarRay& ray : sweep.rays) begin = std::min(begin, double{ray.time});
  return begin;
}

}  // namespace

LidarInjection::LidarInjection(const rosbag::Bag& source, Setup setup)
    : setup_(std::move(setup)), frames_(names::kMapFrame, names::kBaseFrame, kLongestBag) {
  addTransforms(source, frames_, setup_.moved);
  chooseTopics(source);
  learn(source);
}

void LidarInjection::chooseTopics(const rosbag::Bag& source) {
  std::set<std::string> clouds;
  for (const rosbag::ConnectionInfo* connection : rosbag::View(source).getConnections()) {
    if (isCloud(*connection)) clouds.insert(connection->topic);
  }
  for (const std::string& topic : setup_.topics) {
    if (topic == kAllClouds) continue;
    if (clouds.count(topic) == 0) {
      std::string known;
      for (const std::string& cloud : clouds) known += (known.empty() ? "" : ", ") + cloud;
      throw BagError("no sensor_msgs/PointCloud2 on " + topic + "; the bag has " +
                     (known.empty() ? "no clouds" : "clouds on " + known));
    }
    counts_[topic];
  }
  if (!counts_.empty()) return;
  for (const std::string& topic : clouds) {
    if (!isOfRadar(source, topic)) counts_[topic];
  }
  if (counts_.empty()) {
    throw BagError("the bag has no sensor_msgs/PointCloud2 of a lidar (--lidar auto)");
  }
}

void LidarInjection::learn(const rosbag::Bag& source) {
  for (const auto& [topic, _] : counts_) {
    rosbag::View view(source, rosbag::TopicQuery(topic));
    const std::size_t stride = std::max<std::size_t>(1, view.size() / kClouds);
    std::size_t number = 0;
    for (const rosbag::MessageInstance& instance : view) {
      if (number++ % stride != 0) continue;
      const auto message = instance.instantiate<sensor_msgs::PointCloud2>();
      if (!message) continue;
      try {
        learnFrom(*message);
      } catch (const CloudError&) {
        continue;  // edit() counts it
      }
    }
  }
  background_.finish();
}

void LidarInjection::learnFrom(sensor_msgs::PointCloud2& message) {
  const auto sensor = sensorOf(message.header, 0.0);
  if (!sensor) return;
  const PointCloud cloud = takeCloud(message);
  const CloudLayout layout(cloud);
  const SweepRays sweep =
      raysOf(cloud, layout, {message.header.stamp.toSec(), setup_.options.sweep_time});
  std::vector<PosedBody> bodies;
  const std::vector<collision_forge::Agent> agents =
      agentsAt(*setup_.recorded, message.header.stamp);
  if (setup_.vacated) addToBackground(cloud, layout, sweep, sensor->end, agents);
  for (const collision_forge::Agent& agent : agents) {
    if (!hasKnownBox(agent)) continue;
    const Eigen::Vector3d position = bottomOf(agent).translation();
    if ((position - sensor->end.translation()).norm() > kLearnReach) continue;
    bodies.push_back(bodyInCloud(movingAgent(agent, beginOf(sweep)), *sensor, sweep));
  }
  surfaces_.learn(cloud, layout, sweep, bodies);
}

void LidarInjection::addToBackground(const PointCloud& cloud, const CloudLayout& layout,
                                     const SweepRays& sweep, const Eigen::Isometry3d& sensor,
                                     const std::vector<collision_forge::Agent>& agents) {
  if (agents.empty()) return;  // nobody knows what moves
  std::vector<VacatedBox> movers;
  for (const collision_forge::Agent& agent : agents) {
    movers.push_back(
        {bottomOf(agent), sizeOf(agent), {agent.velocity.x, agent.velocity.y, agent.velocity.z}});
  }
  background_.add(cloud, layout, sweep, sensor, movers);
}

std::optional<SensorInSweep> LidarInjection::sensorOf(const std_msgs::Header& header,
                                                      double begin_time) const {
  const std::string frame = frameName(header.frame_id);
  const auto end = frames_.poseOf(frame, header.stamp);
  if (!end) return std::nullopt;
  if (setup_.options.is_motion_corrected || begin_time == 0.0) return SensorInSweep{*end, *end};
  const auto begin = frames_.poseOf(frame, header.stamp + ros::Duration(begin_time));
  return SensorInSweep{begin.value_or(*end), *end};
}

bool LidarInjection::edit(const std::string& topic, sensor_msgs::PointCloud2& message) {
  Counts& counts = counts_.at(topic);
  ++counts.clouds;
  try {
    if (editCounted(message, counts)) {
      ++counts.changed;
      return true;
    }
  } catch (const CloudError& error) {
    ++counts.problems[error.what()];
  } catch (const std::invalid_argument& error) {
    ++counts.problems[error.what()];
  }
  return false;
}

bool LidarInjection::editCounted(sensor_msgs::PointCloud2& message, Counts& counts) {
  const ros::Time stamp = message.header.stamp;
  const ros::Time begin_stamp = std::max(stamp, ros::Time(setup_.options.sweep_time)) -
                                ros::Duration(setup_.options.sweep_time);
  const auto placed = setup_.placed(stamp);
  const auto vacated = setup_.vacated ? setup_.vacated(stamp) : Agents();
  if (placed.empty() && vacated.empty()) return false;
  const auto sensor = sensorOf(message.header, -setup_.options.sweep_time);
  if (!sensor) {
    ++counts.problems["no transform from " + std::string(names::kMapFrame) + " to " +
                      message.header.frame_id + " at the stamp"];
    return false;
  }
  PointCloud cloud = takeCloud(message);
  const CloudLayout layout(cloud);
  const SweepRays sweep = raysOf(cloud, layout, {stamp.toSec(), setup_.options.sweep_time});
  for (const std::string& note : sweep.notes) ++counts.problems[note];
  CloudEdit edit;
  edit.range_noise = setup_.options.range_noise;
  edit.seed = setup_.seed ^ stamp.toNSec();
  const auto before = setup_.placed(begin_stamp);
  for (const collision_forge::Agent& agent : placed) {
    const auto earlier = std::find_if(before.begin(), before.end(),
                                      [&](const auto& other) { return other.id == agent.id; });
    const AgentInSweep posed{earlier == before.end() ? agent : *earlier, agent,
                             (begin_stamp - stamp).toSec(), 0.0};
    edit.bodies.push_back(bodyInCloud(posed, *sensor, sweep, setup_.seed));
  }
  const BackgroundOfSensor background(background_, sensor->end);
  if (!vacated.empty()) edit.background = &background;
  for (const collision_forge::Agent& agent : vacated) {
    const AgentInSweep posed = movingAgent(agent, (begin_stamp - stamp).toSec());
    edit.vacated.push_back(vacatedBoxOf(bodyInCloud(posed, *sensor, sweep)));
  }
  const CloudChange change = editCloud(cloud, layout, sweep, edit, surfaces_);
  putCloud(std::move(cloud), message);
  counts.points.on_bodies += change.on_bodies;
  counts.points.added += change.added;
  counts.points.removed += change.removed;
  counts.points.vacated += change.vacated;
  counts.points.filled += change.filled;
  return change.on_bodies + change.removed + change.vacated > 0;
}

std::vector<std::string> LidarInjection::summary() const {
  std::vector<std::string> lines;
  for (const auto& [topic, counts] : counts_) {
    const CloudChange& points = counts.points;
    std::string line = topic + ": " + counted(counts.changed, counts.clouds, "clouds changed, ") +
                       std::to_string(points.on_bodies) + " points on the attacker, " +
                       std::to_string(points.removed) + " without return now";
    if (points.vacated > 0) {
      line += ", " + std::to_string(points.vacated) + " of its recorded place taken out, " +
              std::to_string(points.filled) + " of them filled from other sweeps";
    }
    lines.push_back(line);
  }
  lines.push_back(surfaces_.learntRays() > 0
                      ? "returns of vehicles: learnt from " +
                            std::to_string(surfaces_.learntRays()) + " rays on recorded ones"
                      : "returns of vehicles: model materials, no recorded vehicle to learn from");
  return lines;
}

std::vector<std::string> LidarInjection::warnings() const {
  std::vector<std::string> lines;
  for (const auto& [topic, counts] : counts_) {
    for (const auto& [problem, count] : counts.problems) {
      lines.push_back(topic + ": " + counted(count, counts.clouds, "clouds: ") + problem);
    }
  }
  return lines;
}

}  // namespace forge
