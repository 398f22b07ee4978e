#pragma once

#include <collision_forge/AgentArray.h>
#include <collision_forge/Attack.h>
#include <collision_forge/CollisionReport.h>
#include <collision_forge/LaneMap.h>
#include <rosbag/message_instance.h>
#include <std_msgs/Header.h>
#include <tf2_msgs/TFMessage.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/base/scene/input_limits.h"
#include "collision_forge/base/scene/scene.h"
#include "collision_forge/ros/bags/mcap_messages.h"
#include "collision_forge/ros/messages/posed_frames.h"

namespace forge {

/// A message type of ROS 1.
struct MadeType {
  std::string name;        ///< package/Type
  std::string definition;  ///< with nested types
  std::string md5;
};

/// A generated topic, added to the file with its first message.
class MadeTopic {
 public:
  /// `name`: from topic_names.h. `file` must outlive the object.
  MadeTopic(McapMessages& file, const char* name, MadeType type, bool latched = false);

  /// Writes a message, serialised as in ROS 1, at `time` of the bag.
  void write(const ros::Time& time, const std::string& message);

 private:
  McapMessages& file_;
  const char* name_;
  MadeType type_;
  bool is_latched_;
  std::optional<std::size_t> number_;  ///< of the topic in the file
};

/// Generates the additional topics of an MCAP file from the messages of its bag: map and frames of
/// agents as 3D scenes, with the attack as known at that time, and the speeds of ego and attacker
/// (m/s). A frame waits until the ego's pose at its stamp is known. Maps, attacks, agents and ego
/// poses outside the input limits are skipped and counted.
class CrashTopics {
 public:
  /// `agents`: topic of the frames in the bag, with its leading slash. `file` must outlive the
  /// object.
  CrashTopics(McapMessages& file, const EgoVehicle& ego, const InputLimits& limits,
              std::string agents);

  /// Processes a message of the bag; call in the order of time.
  void take(const rosbag::MessageInstance& instance);

  /// Returns one line per topic with the number of entries that were skipped.
  std::vector<std::string> warnings() const;

 private:
  // With a header, for PosedFrames, and the time in the bag.
  struct Frame {
    std_msgs::Header header;
    ros::Time time;
    collision_forge::AgentArray agents;
  };
  struct Place {
    std_msgs::Header header;
    ros::Time time;
  };

  bool isShown(const collision_forge::Agent& agent) const;
  /// Returns true if `check` does not throw InputError or MessageError; else counts the message.
  template <typename Check>
  bool isWithinLimits(const char* topic, const Check& check);
  void takeMap(const collision_forge::LaneMap& map, const ros::Time& time);
  void takeTransforms(const tf2_msgs::TFMessage& message, const ros::Time& time, bool is_static);
  void takeAttack(const collision_forge::Attack& attack);
  void takeAgents(collision_forge::AgentArray agents, const ros::Time& time);
  void writePosed();
  void showSpeed(const Place& place, const Pose2& base);
  void show(const Frame& frame, const Pose2& base);

  EgoVehicle ego_;
  InputLimits limits_;
  std::string agents_;
  PosedFrames<Frame> frames_;
  PosedFrames<Place> places_;       ///< poses of base_link
  std::optional<AgentState> base_;  ///< newest pose
  std::optional<collision_forge::Attack> attack_;
  std::optional<collision_forge::CollisionReport> tested_;
  MadeTopic scene_;
  MadeTopic map_;
  MadeTopic ego_speed_;
  MadeTopic attacker_speed_;
  std::map<std::string, int> not_shown_;  ///< by topic
};

}  // namespace forge
