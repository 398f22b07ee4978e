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

/// A topic of profile ros1 whose messages the suite makes; its channel is there from the first on.
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

/// What an MCAP file has beside the messages of its bag, made of these as they come: the map and
/// every frame of agents as scenes, with what is known of the attack by then, and how fast ego and
/// attacker are. A frame is shown when the ego's place at its stamp is known, and not before. What
/// is beyond the limits of input is not shown.
class CrashTopics {
 public:
  /// `agents`: the topic of the frames, as the bag names it.
  CrashTopics(McapWriter& writer, const EgoVehicle& ego, const InputLimits& limits,
              std::string agents);

  /// A message of the bag, in the order of time.
  void take(const rosbag::MessageInstance& instance);

  /// What was not shown, a line a topic.
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
  /// Whether `check` does not throw; counts where it does.
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
