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
#include "collision_forge/ros/bags/mcap_writer.h"
#include "collision_forge/ros/messages/posed_frames.h"

namespace forge {

/// A topic of profile ros1 with generated messages; its channel is added with the first message.
class MadeTopic {
 public:
  /// `name` of topic_names.h; the schema's encoding is set here.
  MadeTopic(McapWriter& writer, const char* name, McapSchema schema, const char* md5,
            bool latched = false);

  void write(const ros::Time& time, const std::string& message);

 private:
  McapWriter& writer_;
  McapSchema schema_;
  McapChannel channel_;
  std::optional<std::uint16_t> number_;  ///< of the channel
};

/// Writes generated topics beside a bag's messages to an MCAP file: map and frames of agents as
/// scenes, with the attack known by then, and the speeds of ego and attacker. Shows a frame once
/// the ego's pose at its stamp is known. Leaves out messages beyond the limits of input.
class CrashTopics {
 public:
  /// `agents`: the topic of the frames, as the bag names it.
  CrashTopics(McapWriter& writer, const EgoVehicle& ego, const InputLimits& limits,
              std::string agents);

  /// Takes the next message of the bag, in order of time.
  void take(const rosbag::MessageInstance& instance);

  /// Returns a line for each topic with messages that were left out.
  std::vector<std::string> warnings() const;

 private:
  // With a header, as PosedFrames wants it, and the time in the bag.
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
  /// Returns false and counts the message if `check` throws.
  template <typename Check>
  bool isWithinLimits(const char* topic, const Check& check);
  void takeMap(const collision_forge::LaneMap& map, const ros::Time& time);
  void takeTransforms(const tf2_msgs::TFMessage& message, const ros::Time& time, bool is_static);
  void takeAttack(const collision_forge::Attack& attack);
  void takeAgents(collision_forge::AgentArray agents, const ros::Time& time);
  void tell();
  void showSpeed(const Place& place, const Pose2& base);
  void show(const Frame& frame, const Pose2& base);

  EgoVehicle ego_;
  InputLimits limits_;
  std::string agents_;
  PosedFrames<Frame> frames_;
  PosedFrames<Place> places_;       ///< of base_link
  std::optional<AgentState> base_;  ///< the newest of them
  std::optional<collision_forge::Attack> attack_;
  std::optional<collision_forge::CollisionReport> tested_;
  MadeTopic scene_;
  MadeTopic map_;
  MadeTopic ego_speed_;
  MadeTopic attacker_speed_;
  std::map<std::string, int> not_shown_;  ///< by topic
};

}  // namespace forge
