#pragma once

#include <collision_forge/Agent.h>
#include <collision_forge/AgentArray.h>
#include <rosbag/bag.h>

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "collision_forge/attack/verify/post_crash_motion.h"
#include "collision_forge/ros/injection/attacker_injector.h"
#include "collision_forge/ros/injection/bag_attack.h"
#include "collision_forge/ros/injection/record_clock.h"

namespace forge {

/// A frame of agents with the attacker.
struct AttackedFrame {
  ros::Time recorded;  ///< record time
  collision_forge::AgentArray agents;
  bool is_recorded = true;
  bool is_mended = false;  ///< non-finite agents were removed
};

/// The frames of agents of an attacked bag: the recorded frames with the attacker and its supports,
/// and the additional frames of injectIntoBag(). Times are header stamps. Not thread-safe.
class AttackedFrames {
 public:
  /// Sorted by header stamp, then by record time.
  using Frames = std::map<std::pair<ros::Time, ros::Time>, AttackedFrame>;

  /// Reads the agents of `source` and makes the frames up to the stamp `end`. `crash`: motion of
  /// the attacker after the contact; empty: it follows its trajectory. `attack` must outlive this
  /// object. Throws MessageError for an invalid trajectory, and rosbag::BagException.
  AttackedFrames(const rosbag::Bag& source, const BagAttack& attack,
                 const RecordingContext& recording, const std::optional<PostCrashMotion>& crash,
                 const ros::Time& end);

  const Frames& frames() const { return frames_; }
  /// Returns the frames as recorded, sorted by stamp, if clouds are changed; else none.
  const std::vector<collision_forge::AgentArray>& recorded() const { return recorded_; }
  /// Returns the clock of the recorded frames.
  const RecordClock& clock() const { return clock_; }
  /// Returns the header of the agents' connection; null without agents.
  const boost::shared_ptr<ros::M_string>& header() const { return header_; }
  /// Returns the number of changes that keepFinite() made in all frames.
  int leftOut() const { return left_out_; }

  /// Returns true if the attack changes messages with this stamp.
  bool isChangedAt(const ros::Time& stamp) const;
  /// Returns the attacker and its supports, while they drive elsewhere than recorded.
  std::vector<collision_forge::Agent> placedAt(const ros::Time& time);
  /// Returns the attacker and its supports as recorded, each while it drives elsewhere: after t0.
  /// Returns none if recorded() is empty.
  std::vector<collision_forge::Agent> vacatedAt(const ros::Time& time) const;

 private:
  void addFrame(const AttackedFrame& frame);
  /// Returns the frame with the supports and the attacker.
  collision_forge::AgentArray injected(collision_forge::AgentArray agents);
  /// Adds no frames in a gap without known motion of the other agents.
  void addFramesBetween(const collision_forge::AgentArray& before,
                        const collision_forge::AgentArray& after, double frame_rate);

  const BagAttack& attack_;
  std::vector<AttackerInjector> injectors_;            ///< of the supports and of the attacker
  std::vector<collision_forge::AgentArray> recorded_;  ///< frames of agents, if clouds are changed
  RecordClock clock_;
  Frames frames_;
  boost::shared_ptr<ros::M_string> header_;
  int left_out_ = 0;
};

}  // namespace forge
