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
  std::string definition;  ///< text of the message definition, with nested types
  std::string md5;         ///< MD5 sum of the type, as in ros::message_traits
};

/// A generated topic, added to the file with its first message.
class MadeTopic {
 public:
  /// `name`: from topic_names.h, without leading slash; must outlive the object, as must `file`.
  MadeTopic(McapMessages& file, const char* name, MadeType type, bool latched = false);

  /// Writes a message, `message` serialised as in ROS 1, with the record time `time`.
  void write(const ros::Time& time, const std::string& message);

 private:
  McapMessages& file_;
  const char* name_;
  MadeType type_;
  bool is_latched_;
  std::optional<std::size_t> number_;  ///< of the topic in the file; empty before the first message
};

/// Generates the additional topics of an MCAP file from the messages of its bag: map and frames of
/// agents as 3D scenes (collision_forge/map, collision_forge/scene), with the attack from its t0
/// on, and the speeds of ego and attacker, m/s (collision_forge/ego_speed, .../attacker_speed). A
/// frame waits until the ego's pose at its stamp is known; a frame without one is never shown. The
/// ego's speed is its mean since the previous pose, left out after a gap above kMaxGap; the
/// attacker's is its velocity in the frame, from t0 on. Maps, attacks, agents and ego poses outside
/// the input limits are skipped and counted. Not thread-safe.
class CrashTopics {
 public:
  /// `agents`: topic of the frames in the bag, with its leading slash. `ego`: size of the shown ego
  /// and offset from base_link to the box centre; /ego_vehicle in the bag is not used. `file` must
  /// outlive the object.
  CrashTopics(McapMessages& file, const EgoVehicle& ego, const InputLimits& limits,
              std::string agents);

  /// Processes a message of the bag and writes the generated messages that it completes, with the
  /// record times of the messages that they show. Call for all messages in the order of record
  /// time; messages of other topics are ignored. Throws as readMessage() and McapMessages.
  void take(const rosbag::MessageInstance& instance);

  /// Returns one line per topic with the number of entries that were skipped, sorted by topic; none
  /// if no entry was skipped.
  std::vector<std::string> warnings() const;

 private:
  // Elements of PosedFrames, which needs the header. `time`: record time in the bag.
  struct Frame {
    std_msgs::Header header;
    ros::Time time;
    collision_forge::AgentArray agents;
  };
  struct Place {
    std_msgs::Header header;  ///< of a transform that moves the ego
    ros::Time time;
  };

  /// Returns true if pose, size and speed are within the input limits.
  bool isShown(const collision_forge::Agent& agent) const;
  /// Returns true if `check` does not throw InputError or MessageError; else counts the message.
  template <typename Check>
  bool isWithinLimits(const char* topic, const Check& check);
  void takeMap(const collision_forge::LaneMap& map, const ros::Time& time);
  void takeTransforms(const tf2_msgs::TFMessage& message, const ros::Time& time, bool is_static);
  void takeAttack(const collision_forge::Attack& attack);
  void takeAgents(collision_forge::AgentArray agents, const ros::Time& time);
  /// Writes the speeds and scenes for which the ego's pose is known by now.
  void writePosed();
  /// Writes the ego's mean speed since the previous pose. `base`: pose of base_link in the map.
  void showSpeed(const Place& place, const Pose2& base);
  /// Writes the 3D scene of a frame and the attacker's speed.
  void show(const Frame& frame, const Pose2& base);

  EgoVehicle ego_;
  InputLimits limits_;
  std::string agents_;  ///< topic
  PosedFrames<Frame> frames_;
  PosedFrames<Place> places_;                               ///< for the poses of base_link
  std::optional<AgentState> base_;                          ///< newest pose of base_link
  std::optional<collision_forge::Attack> attack_;           ///< the newest; empty: none, or ended
  std::optional<collision_forge::CollisionReport> tested_;  ///< newest tested_report
  MadeTopic scene_;
  MadeTopic map_;
  MadeTopic ego_speed_;
  MadeTopic attacker_speed_;
  std::map<std::string, int> not_shown_;  ///< number of skipped entries, by topic
};

}  // namespace forge
