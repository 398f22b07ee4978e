#include "collision_forge/ros/bags/foreign_bag.h"

#include <rosbag/view.h>

#include <algorithm>
#include <deque>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "collision_forge/ros/bags/bag_frames.h"
#include "collision_forge/ros/bags/read_opened.h"
#include "collision_forge/ros/bags/topic_values.h"
#include "collision_forge/ros/messages/same_instant.h"

namespace forge {
namespace {

std::int64_t microsecondsOf(std::int64_t nanoseconds) { return (nanoseconds + 500) / 1000; }

ros::Time timeOf(std::int64_t nanoseconds) {
  constexpr std::int64_t kSecond = 1000000000;  // ns
  return {static_cast<std::uint32_t>(nanoseconds / kSecond),
          static_cast<std::uint32_t>(nanoseconds % kSecond)};
}

/// Collects a recording message by message. Poses and frames of agents wait until the transforms to
/// the map frame at their stamp are known.
class RecordingBuilder {
 public:
  RecordingBuilder(const TopicMapping& mapping, const EgoVehicle& ego)
      : mapping_(mapping),
        ego_(ego),
        map_frame_(frameName(mapping.map_frame)),
        ego_frame_(frameName(mapping.ego.child_frame_id)),
        ego_values_(mapping.ego.fields),
        agent_values_(mapping.agents.fields),
        frames_(map_frame_, ego_frame_) {
    if (!mapping.ego.in_transforms) ego_values_.want(mapping.ego.pose);
    const AgentsMapping& agents = mapping.agents;
    agent_values_.want(agents.id, FieldKind::kText);
    agent_values_.want(agents.classification, FieldKind::kText);
    if (!agents.probability.empty()) agent_values_.want(NumberSource(agents.probability));
    agent_values_.want(agents.pose);
    agent_values_.want(agents.size);
    if (agents.velocity) agent_values_.want(agents.velocity->velocity);
  }

  void add(const rosbag::ConnectionInfo& connection) {
    if (connection.topic == mapping_.agents.fields.topic) agent_values_.add(connection);
    if (connection.topic != mapping_.ego.fields.topic) return;
    if (!mapping_.ego.in_transforms) {
      ego_values_.add(connection);
    } else if (connection.md5sum != ros::message_traits::md5sum<tf2_msgs::TFMessage>()) {
      throw BagError("is of type " + connection.datatype + ", not " + mapping_.ego.fields.type);
    }
  }

  void add(const rosbag::MessageInstance& instance) {
    const std::string& topic = instance.getTopic();
    if (topic == mapping_.transformTopic()) addTransforms(instance, false);
    if (topic == mapping_.ego.fields.topic && !mapping_.ego.in_transforms) addEgo(instance);
    if (topic == mapping_.agents.fields.topic) addAgents(instance);
    takeReady(false);
  }

  /// Adds a message of /tf_static; all of them before add().
  void addStatic(const rosbag::MessageInstance& instance) { addTransforms(instance, true); }

  /// Appends the counts of unusable data to `left_out`.
  NuScenesRecording finish(std::vector<std::string>& left_out) {
    takeReady(true);
    if (!mapping_.agents.velocity) deriveVelocities(recording_);
    for (const auto& [what, count] : left_out_) {
      left_out.push_back(std::to_string(count) + " " + what + " left out");
    }
    if (lacks_transforms_) {
      left_out.push_back("map_frame of the mapping is " + map_frame_ +
                         ", transforms of the bag: " + frames_.described());
    }
    return std::move(recording_);
  }

 private:
  /// A frame of agents, relative to the frame `source`.
  struct WaitingFrame {
    std::string source;
    std::int64_t nanoseconds;
    NuScenesFrame frame;
  };

  void addTransforms(const rosbag::MessageInstance& instance, bool is_static) {
    const auto message = instance.instantiate<tf2_msgs::TFMessage>();
    if (!message) return;
    const auto transforms = usableTransforms(*message);
    count("transforms that are not finite", message->transforms.size() - transforms.size());
    for (const geometry_msgs::TransformStamped& transform : transforms) {
      const bool in_ego_topic =
          !mapping_.ego.in_transforms && transform.child_frame_id == ego_frame_;
      if (!in_ego_topic) addTransform(transform, is_static);
    }
  }

  void addTransform(const geometry_msgs::TransformStamped& transform, bool is_static) {
    const bool is_used = frames_.add(transform, is_static);
    if (is_static || !mapping_.ego.in_transforms || !frames_.movesEgo(transform)) return;
    if (is_used) {
      ego_times_.push_back(static_cast<std::int64_t>(transform.header.stamp.toNSec()));
      last_move_ = transform;
    } else if (transform.header.frame_id == last_move_.header.frame_id) {
      checkRepeated(transform);
    }
  }

  /// Counts an unused transform of the ego. Throws BagError if it contradicts the one before.
  void checkRepeated(const geometry_msgs::TransformStamped& transform) {
    const auto& [x, y, z] = transform.transform.translation;
    const auto& last = last_move_.transform.translation;
    const auto time_us = [](const geometry_msgs::TransformStamped& moved) {
      return microsecondsOf(static_cast<std::int64_t>(moved.header.stamp.toNSec()));
    };
    if (transform.header.stamp.isZero()) {
      count("ego poses whose stamp is not set");
    } else if (!isSameInstant(time_us(transform), time_us(last_move_))) {
      count("ego poses whose stamp is earlier than the previous one");
    } else {
      requireSamePlace({x - last.x, y - last.y, z - last.z}, time_us(transform));
    }
  }

  static void requireSamePlace(const Eigen::Vector3d& apart, std::int64_t time_us) {
    if (apart.norm() > kSamePlace) throw BagError(contradiction(apart.norm(), time_us));
  }

  /// Removes and converts what waits, in order, as far as its transforms are known. `at_end`: drops
  /// the rest.
  void takeReady(bool at_end) {
    while (!ego_times_.empty()) {
      const ros::Time time = timeOf(ego_times_.front());
      const auto pose = frames_.poseOf(ego_frame_, time);
      if (!pose && !at_end && !frames_.isPast(time)) break;
      if (pose) {
        const NuScenesEgoPose found{microsecondsOf(ego_times_.front()), pose->translation(),
                                    Eigen::Quaterniond(pose->linear())};
        keep(mapping_.ego.in_transforms ? ofBase(found) : found);
      } else {
        countWithoutTransforms("ego poses", ego_frame_);
      }
      ego_times_.pop_front();
    }
    while (!waiting_.empty()) {
      const ros::Time time = timeOf(waiting_.front().nanoseconds);
      const auto pose = frames_.poseOf(waiting_.front().source, time);
      if (!pose && !at_end && !frames_.isPast(time)) break;
      if (pose) {
        addFrame(std::move(waiting_.front()), *pose);
      } else {
        countWithoutTransforms("frames of agents", waiting_.front().source);
      }
      waiting_.pop_front();
    }
  }

  void count(const std::string& what, std::size_t number = 1) {
    if (number > 0) left_out_[what] += number;
  }

  void countWithoutTransforms(const std::string& what, const std::string& frame) {
    count(what + " without transforms from " + map_frame_ + " to " + frame + " at their stamp");
    lacks_transforms_ = true;
  }

  void addEgo(const rosbag::MessageInstance& instance) {
    ego_values_.take(instance);
    const std::string frame = ego_values_.frame(map_frame_);
    const std::int64_t nanoseconds = ego_values_.nanoseconds();
    NuScenesEgoPose pose{microsecondsOf(nanoseconds),
                         ego_values_.vector(mapping_.ego.pose.position, 0),
                         ego_values_.rotation(mapping_.ego.pose, 0)};
    if (!pose.translation.allFinite() || !pose.rotation.coeffs().allFinite()) {
      count("ego poses that are not finite");
      return;
    }
    if (pose.timestamp_us == 0) {
      count("ego poses whose stamp is not set");
      return;
    }
    const NuScenesEgoPose base = ofBase(pose);
    frames_.addPose(frame, ego_frame_, timeOf(nanoseconds),
                    Eigen::Translation3d(base.translation) * base.rotation);
    if (frame == map_frame_) {
      keep(base);
    } else {
      ego_times_.push_back(nanoseconds);
    }
  }

  /// Returns the pose of base_link for a pose of the mapping's reference point.
  NuScenesEgoPose ofBase(NuScenesEgoPose pose) const {
    if (mapping_.ego.reference == EgoReference::kBoxMiddle) {
      pose.translation -= pose.rotation * Eigen::Vector3d(ego_.center_offset, 0.0, 0.0);
    }
    return pose;
  }

  /// Adds a pose of the ego in the map frame.
  void keep(const NuScenesEgoPose& base) {
    auto& poses = recording_.ego_poses;
    const std::int64_t last = poses.empty() ? 0 : poses.back().timestamp_us;
    if (!poses.empty() && isSameInstant(base.timestamp_us, last)) {
      requireSamePlace(base.translation - poses.back().translation, base.timestamp_us);
    } else if (base.timestamp_us > last) {
      poses.push_back(base);
    } else {
      count("ego poses whose stamp is earlier than the previous one");
    }
  }

  void addAgents(const rosbag::MessageInstance& instance) {
    agent_values_.take(instance);
    WaitingFrame waiting{agent_values_.frame(map_frame_), agent_values_.nanoseconds(), {}};
    NuScenesFrame& frame = waiting.frame;
    frame.timestamp_us = microsecondsOf(waiting.nanoseconds);
    if (frame.timestamp_us == 0) {
      count("frames of agents whose stamp is not set");
      return;
    }
    if (frame.timestamp_us <= last_frame_us_ || isSameInstant(frame.timestamp_us, last_frame_us_)) {
      count("frames of agents whose stamp is not later than the previous one");
      return;
    }
    last_frame_us_ = frame.timestamp_us;
    std::set<std::string> ids = {kEgoId, ""};
    for (std::size_t row = 0; row < agent_values_.rows(mapping_.agents.id); ++row) {
      NuScenesAnnotation agent = agentAt(row);
      if (!agent.velocity.allFinite()) {
        agent.velocity.setZero();
        count("velocities of agents that are not finite");
      }
      if (!agent.translation.allFinite() || !agent.rotation.coeffs().allFinite() ||
          !(agent.size.minCoeff() > 0.0) || !agent.size.allFinite()) {
        count("agents that are not finite or have no size");
      } else if (!ids.insert(agent.instance).second) {
        count("agents without an id, or with the id of another agent or the ego");
      } else {
        frame.annotations.push_back(std::move(agent));
      }
    }
    waiting_.push_back(std::move(waiting));
  }

  /// Adds a frame of agents whose source frame has the pose `source` in the map frame.
  void addFrame(WaitingFrame waiting, const Eigen::Isometry3d& source) {
    const Eigen::Quaterniond rotation(source.linear());
    if (waiting.source != map_frame_) {
      for (NuScenesAnnotation& agent : waiting.frame.annotations) {
        agent.translation = source * agent.translation;
        agent.rotation = rotation * agent.rotation;
        agent.velocity = rotation * agent.velocity;
      }
    }
    recording_.frames.push_back(std::move(waiting.frame));
  }

  NuScenesAnnotation agentAt(std::size_t row) const {
    const AgentsMapping& agents = mapping_.agents;
    NuScenesAnnotation agent;
    agent.instance = agent_values_.text(agents.id, row);
    agent.category = categoryOf(classAt(row));
    agent.translation = agent_values_.vector(agents.pose.position, row);
    agent.rotation = agent_values_.rotation(agents.pose, row);
    agent.size = agent_values_.vector(agents.size, row);
    if (!agents.velocity) return agent;
    agent.velocity = agent_values_.vector(agents.velocity->velocity, row);
    if (agents.velocity->frame == VelocityFrame::kObject) {
      agent.velocity = agent.rotation * agent.velocity;
    }
    return agent;
  }

  AgentClass classAt(std::size_t row) const {
    const AgentsMapping& agents = mapping_.agents;
    const auto& found = agent_values_.all(agents.classification, row);
    std::size_t likeliest = 0;
    if (!agents.probability.empty()) {
      const auto& shares = agent_values_.all(agents.probability, row);
      likeliest =
          static_cast<std::size_t>(std::max_element(shares.begin(), shares.end()) - shares.begin());
    }
    if (likeliest >= found.size()) return agents.default_class;
    const auto known = agents.classes.find(std::get<std::string>(found[likeliest]));
    return known == agents.classes.end() ? agents.default_class : known->second;
  }

  const TopicMapping& mapping_;
  const EgoVehicle& ego_;
  std::string map_frame_;
  std::string ego_frame_;
  TopicValues ego_values_;
  TopicValues agent_values_;
  BagFrames frames_;
  geometry_msgs::TransformStamped last_move_;  ///< newest used transform that moves the ego
  std::deque<std::int64_t> ego_times_;         ///< ns, of the poses that wait
  std::deque<WaitingFrame> waiting_;
  std::int64_t last_frame_us_ = 0;
  NuScenesRecording recording_;
  std::map<std::string, std::size_t> left_out_;
  bool lacks_transforms_ = false;
};

std::string topicsOf(const rosbag::Bag& bag) {
  std::set<std::string> topics;
  rosbag::View view(bag);
  for (const rosbag::ConnectionInfo* connection : view.getConnections()) {
    topics.insert(connection->topic);
  }
  std::string text;
  for (const std::string& topic : topics) text += (text.empty() ? "" : ", ") + topic;
  return text;
}

}  // namespace

NuScenesRecording readForeignBag(const std::string& path, const TopicMapping& mapping,
                                 const EgoVehicle& ego, std::vector<std::string>* warnings) {
  const auto& ego_topic = mapping.ego.fields.topic;
  const auto& agents_topic = mapping.agents.fields.topic;
  std::vector<std::string> left_out;
  NuScenesRecording recording = readOpened(path, [&](const rosbag::Bag& bag) {
    RecordingBuilder builder(mapping, ego);
    const std::string transforms = mapping.transformTopic();
    rosbag::View fixed(bag, rosbag::TopicQuery(transforms + "_static"));
    for (const rosbag::MessageInstance& instance : fixed) builder.addStatic(instance);
    rosbag::View view(
        bag, rosbag::TopicQuery(std::vector<std::string>{ego_topic, agents_topic, transforms}));
    std::set<std::string> topics;
    const auto add = [&](const auto& item, const std::string& topic) {
      try {
        builder.add(item);
      } catch (const BagError& error) {
        throw BagError(path + ": " + topic + ": " + error.what());
      }
      topics.insert(topic);
    };
    for (const rosbag::ConnectionInfo* connection : view.getConnections()) {
      add(*connection, connection->topic);
    }
    for (const std::string& topic : {ego_topic, agents_topic}) {
      if (topics.count(topic) > 0) continue;
      throw BagError(path + ": no message on " + topic + "; the bag has " + topicsOf(bag));
    }
    for (const rosbag::MessageInstance& instance : view) add(instance, instance.getTopic());
    try {
      return builder.finish(left_out);
    } catch (const BagError& error) {
      throw BagError(path + ": " + error.what());
    }
  });
  const auto fail = [&](const std::string& problem) {
    std::string text = path + ": " + problem;
    for (const std::string& what : left_out) text += "; " + what;
    throw BagError(text);
  };
  if (recording.ego_poses.empty()) fail("no pose of the ego on " + ego_topic);
  if (recording.frames.empty()) fail("no frame of agents on " + agents_topic);
  if (warnings) warnings->insert(warnings->end(), left_out.begin(), left_out.end());
  recording.name = std::filesystem::path(path).stem().string();
  return recording;
}

}  // namespace forge
