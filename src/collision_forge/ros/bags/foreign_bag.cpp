#include "collision_forge/ros/bags/foreign_bag.h"

#include <rosbag/view.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "collision_forge/base/scene/formatted.h"
#include "collision_forge/ros/bags/message_fields.h"
#include "collision_forge/ros/bags/read_opened.h"
#include "collision_forge/ros/messages/same_instant.h"

namespace forge {
namespace {

constexpr std::int64_t kClockGap = 10000000;  // us; stamps farther apart belong to different clocks

/// The mapped fields of a topic and their values in the newest message. The value of a missing
/// field is NaN, empty or 0.
class TopicValues {
 public:
  explicit TopicValues(const TopicFields& topic) : topic_(topic) {
    want(topic.stamp, FieldKind::kTime);
    if (!topic.frame_id.empty()) want(topic.frame_id_path, FieldKind::kText);
  }

  void want(const std::string& path, FieldKind kind) {
    if (columns_.try_emplace(path, paths_.size()).second) paths_.push_back({path, kind});
  }
  void want(const NumberSource& source) {
    if (const auto* path = std::get_if<std::string>(&source)) want(*path, FieldKind::kNumber);
  }
  template <std::size_t count>
  void want(const std::array<NumberSource, count>& sources) {
    for (const NumberSource& source : sources) want(source);
  }
  void want(const PoseFields& pose) {
    want(pose.position);
    std::visit([this](const auto& orientation) { want(orientation); }, pose.orientation);
  }

  /// Adds a connection of the topic; throws BagError if its type differs from the mapping or lacks
  /// a field.
  void add(const rosbag::ConnectionInfo& connection) {
    if (connection.datatype != topic_.type) {
      throw BagError("is of type " + connection.datatype + ", not " + topic_.type);
    }
    readers_[connection.header] =
        std::make_unique<MessageFields>(connection.datatype, connection.msg_def, paths_);
  }

  void take(const rosbag::MessageInstance& instance) {
    bytes_.resize(instance.size());
    ros::serialization::OStream stream(bytes_.data(), static_cast<std::uint32_t>(bytes_.size()));
    instance.write(stream);
    values_ = readers_.at(instance.getConnectionHeader())->read(bytes_.data(), bytes_.size());
  }

  std::size_t rows(const std::string& path) const { return values_[columns_.at(path)].size(); }

  /// Returns all values in a row; empty if there is no such row.
  const std::vector<FieldValue>& all(const std::string& path, std::size_t row) const {
    static const std::vector<FieldValue> none;
    const FieldRows& rows = values_[columns_.at(path)];
    return row < rows.size() ? rows[row] : none;
  }
  std::string text(const std::string& path, std::size_t row) const {
    const auto& values = all(path, row);
    return values.empty() ? "" : std::get<std::string>(values.front());
  }
  double number(const NumberSource& source, std::size_t row) const {
    if (const auto* constant = std::get_if<double>(&source)) return *constant;
    const auto& values = all(std::get<std::string>(source), row);
    return values.empty() ? std::nan("") : std::get<double>(values.front());
  }
  Eigen::Vector3d vector(const std::array<NumberSource, 3>& sources, std::size_t row) const {
    return {number(sources[0], row), number(sources[1], row), number(sources[2], row)};
  }
  /// Returns the rotation; not finite if the fields describe none.
  Eigen::Quaterniond rotation(const PoseFields& pose, std::size_t row) const {
    if (const auto* yaw = std::get_if<NumberSource>(&pose.orientation)) {
      return Eigen::Quaterniond(Eigen::AngleAxisd(number(*yaw, row), Eigen::Vector3d::UnitZ()));
    }
    const auto& parts = std::get<0>(pose.orientation);
    Eigen::Vector4d coefficients;  // x, y, z, w
    for (int i = 0; i < 4; ++i) coefficients[i] = number(parts[static_cast<std::size_t>(i)], row);
    return Eigen::Quaterniond(Eigen::Vector4d(coefficients / coefficients.norm()));
  }
  std::int64_t microseconds(std::size_t row) const {
    const auto& values = all(topic_.stamp, row);
    constexpr std::int64_t kNanoseconds = 1000;
    return values.empty() ? 0 : (std::get<std::int64_t>(values.front()) + 500) / kNanoseconds;
  }
  std::string frameId(std::size_t row) const { return text(topic_.frame_id_path, row); }

  void requireFrame() const {
    if (topic_.frame_id.empty() || frameId(0) == topic_.frame_id) return;
    throw BagError(topic_.frame_id_path + " is '" + frameId(0) + "', not '" + topic_.frame_id +
                   "'");
  }

 private:
  const TopicFields& topic_;
  std::vector<FieldPath> paths_;
  std::map<std::string, std::size_t> columns_;  ///< of `paths_`, by path
  /// Readers by the header of their connection, which all its messages share.
  std::map<boost::shared_ptr<ros::M_string>, std::unique_ptr<MessageFields>> readers_;
  std::vector<std::uint8_t> bytes_;
  std::vector<FieldRows> values_;
};

/// Collects a recording message by message.
class RecordingBuilder {
 public:
  RecordingBuilder(const TopicMapping& mapping, const EgoVehicle& ego)
      : mapping_(mapping),
        ego_(ego),
        ego_values_(mapping.ego.fields),
        agent_values_(mapping.agents.fields) {
    ego_values_.want(mapping.ego.pose);
    if (isOfTransforms()) ego_values_.want(mapping.ego.child_frame_id_path, FieldKind::kText);
    const AgentsMapping& agents = mapping.agents;
    agent_values_.want(agents.id, FieldKind::kText);
    agent_values_.want(agents.classification, FieldKind::kText);
    if (!agents.probability.empty()) agent_values_.want(NumberSource(agents.probability));
    agent_values_.want(agents.pose);
    agent_values_.want(agents.size);
    if (agents.velocity) agent_values_.want(agents.velocity->velocity);
  }

  void add(const rosbag::ConnectionInfo& connection) {
    if (connection.topic == mapping_.ego.fields.topic) ego_values_.add(connection);
    if (connection.topic == mapping_.agents.fields.topic) agent_values_.add(connection);
  }

  void add(const rosbag::MessageInstance& instance) {
    if (instance.getTopic() == mapping_.ego.fields.topic) addEgo(instance);
    if (instance.getTopic() == mapping_.agents.fields.topic) addAgents(instance);
  }

  /// Appends a line per kind of dropped data to `left_out`.
  NuScenesRecording finish(std::vector<std::string>& left_out) {
    requireOneClock();
    if (!mapping_.agents.velocity) deriveVelocities(recording_);
    for (const auto& [what, count] : left_out_) {
      left_out.push_back(std::to_string(count) + " " + what + " left out");
    }
    return std::move(recording_);
  }

 private:
  /// Throws BagError if the stamps of agents and ego are kClockGap apart.
  void requireOneClock() const {
    const auto& poses = recording_.ego_poses;
    const auto& frames = recording_.frames;
    if (poses.empty() || frames.empty()) return;
    if (frames.front().timestamp_us <= poses.back().timestamp_us + kClockGap &&
        poses.front().timestamp_us <= frames.back().timestamp_us + kClockGap) {
      return;
    }
    const auto range = [](std::int64_t first_us, std::int64_t last_us) {
      return formatted("%.3f to %.3f s", 1e-6 * static_cast<double>(first_us),
                       1e-6 * static_cast<double>(last_us));
    };
    throw BagError(
        "stamps of agents (" + range(frames.front().timestamp_us, frames.back().timestamp_us) +
        ") and of the ego (" + range(poses.front().timestamp_us, poses.back().timestamp_us) +
        ") do not overlap: both must have one clock");
  }

  bool isOfTransforms() const { return !mapping_.ego.child_frame_id.empty(); }

  void addEgo(const rosbag::MessageInstance& instance) {
    ego_values_.take(instance);
    if (!isOfTransforms()) ego_values_.requireFrame();
    for (std::size_t row = 0; row < ego_values_.rows(mapping_.ego.fields.stamp); ++row) {
      if (isOfTransforms() && !isOfEgo(row)) continue;
      addEgoPose(row);
    }
  }

  /// Returns true if the row is the transform of the ego.
  bool isOfEgo(std::size_t row) const {
    return ego_values_.frameId(row) == mapping_.ego.fields.frame_id &&
           ego_values_.text(mapping_.ego.child_frame_id_path, row) == mapping_.ego.child_frame_id;
  }

  void addEgoPose(std::size_t row) {
    NuScenesEgoPose pose;
    pose.timestamp_us = ego_values_.microseconds(row);
    pose.translation = ego_values_.vector(mapping_.ego.pose.position, row);
    pose.rotation = ego_values_.rotation(mapping_.ego.pose, row);
    if (mapping_.ego.reference == EgoReference::kBoxMiddle) {
      pose.translation -= pose.rotation * Eigen::Vector3d(ego_.center_offset, 0.0, 0.0);
    }
    auto& poses = recording_.ego_poses;
    const std::int64_t last = poses.empty() ? 0 : poses.back().timestamp_us;
    if (!pose.translation.allFinite() || !pose.rotation.coeffs().allFinite()) {
      ++left_out_["ego poses that are not finite"];
    } else if (pose.timestamp_us == 0) {
      ++left_out_["ego poses whose stamp is not set"];
    } else if (!poses.empty() && isSameInstant(pose.timestamp_us, last)) {
      const double distance = (pose.translation - poses.back().translation).norm();
      if (distance > kSamePlace) throw BagError(contradiction(distance, pose.timestamp_us));
    } else if (pose.timestamp_us > last) {
      poses.push_back(pose);
    } else {
      ++left_out_["ego poses whose stamp is earlier than the previous one"];
    }
  }

  void addAgents(const rosbag::MessageInstance& instance) {
    agent_values_.take(instance);
    agent_values_.requireFrame();
    auto& frames = recording_.frames;
    NuScenesFrame frame;
    frame.timestamp_us = agent_values_.microseconds(0);
    if (frame.timestamp_us == 0) {
      ++left_out_["frames of agents whose stamp is not set"];
      return;
    }
    if (!frames.empty() && (frame.timestamp_us <= frames.back().timestamp_us ||
                            isSameInstant(frame.timestamp_us, frames.back().timestamp_us))) {
      ++left_out_["frames of agents whose stamp is not later than the previous one"];
      return;
    }
    std::set<std::string> ids = {kEgoId, ""};
    for (std::size_t row = 0; row < agent_values_.rows(mapping_.agents.id); ++row) {
      NuScenesAnnotation agent = agentAt(row);
      if (!agent.velocity.allFinite()) {
        agent.velocity.setZero();
        ++left_out_["velocities of agents that are not finite"];
      }
      if (!agent.translation.allFinite() || !agent.rotation.coeffs().allFinite() ||
          !(agent.size.minCoeff() > 0.0) || !agent.size.allFinite()) {
        ++left_out_["agents that are not finite or have no size"];
      } else if (!ids.insert(agent.instance).second) {
        ++left_out_["agents without an id, or with the id of another agent or the ego"];
      } else {
        frame.annotations.push_back(std::move(agent));
      }
    }
    frames.push_back(std::move(frame));
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
  TopicValues ego_values_;
  TopicValues agent_values_;
  NuScenesRecording recording_;
  std::map<std::string, int> left_out_;
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
    rosbag::View view(bag, rosbag::TopicQuery(std::vector<std::string>{ego_topic, agents_topic}));
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
