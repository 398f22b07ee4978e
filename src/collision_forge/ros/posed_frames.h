#pragma once

#include <collision_forge/AgentArray.h>
#include <geometry_msgs/TransformStamped.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <deque>
#include <optional>

namespace forge {

/// Frames of agents in their order, each with the ego's pose at its time, which it waits for: both
/// come over connections of their own. Not thread-safe.
///
/// tf2_ros has a listener and a filter for this, which lose frames where a replay starts again: the
/// listener tells that by /clock, which comes over a third connection, and what it takes for new
/// then hides what follows; the filter drops what comes before its transform. Here the stamps tell
/// it. The filter also loses a frame whose transform comes from another thread while it is put
/// aside (seen: 1 in 10,000).
class PosedFrames {
 public:
  struct PosedFrame {
    collision_forge::AgentArray::ConstPtr agents;
    geometry_msgs::Transform pose;  ///< of the ego's base in the map
    std::size_t dropped = 0;        ///< frames before it that no transform came for
  };

  /// Poses of the ego that go back by more than kRestart are a replay that starts again: what was
  /// known is forgotten.
  void addTransforms(const tf2_msgs::TFMessage& message, bool is_static);

  /// A frame from before one that waits is of a replay that starts again, too: that one is dropped.
  void addFrame(const collision_forge::AgentArray::ConstPtr& agents);

  /// The oldest frame whose transform is known, once; those before it are dropped.
  std::optional<PosedFrame> next();

 private:
  static constexpr double kRestart = 1.0;      // s
  static constexpr double kCache = 600.0;      // s of transforms that may come before their frames
  static constexpr std::size_t kQueue = 1000;  // frames that may wait

  tf2::BufferCore buffer_{ros::Duration(kCache)};
  ros::Time newest_pose_;
  std::deque<collision_forge::AgentArray::ConstPtr> waiting_;
};

}  // namespace forge
