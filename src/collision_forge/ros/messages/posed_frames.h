#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <boost/shared_ptr.hpp>
#include <deque>
#include <map>
#include <optional>
#include <string>

#include "collision_forge/base/scene/scene_history.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {

/// Finds the transforms of /tf that move the ego: transforms of the first frame from base_link
/// upwards that /tf_static does not fix to its parent.
class EgoMovers {
 public:
  /// Adds transforms of /tf_static.
  void addFixed(const tf2_msgs::TFMessage& message) {
    for (const geometry_msgs::TransformStamped& transform : message.transforms) {
      parents_[transform.child_frame_id] = transform.header.frame_id;
    }
    moving_ = names::kBaseFrame;
    for (std::size_t i = 0; i < parents_.size() && parents_.count(moving_) > 0; ++i) {
      moving_ = parents_[moving_];
    }
  }

  /// Returns true if a transform of /tf moves the ego.
  bool has(const geometry_msgs::TransformStamped& transform) const {
    return transform.child_frame_id == moving_;
  }

 private:
  std::map<std::string, std::string> parents_;  // by child, from /tf_static
  std::string moving_ = names::kBaseFrame;
};

/// Pairs stamped messages with the ego's pose at their time, in their order. Messages wait for the
/// pose, since both arrive over separate connections. Not thread-safe.
///
/// tf2_ros has a listener and a filter for this, which lose frames where a replay starts again: the
/// listener tells that by /clock, which comes over a third connection, and what it takes for new
/// then hides what follows; the filter drops what comes before its transform. Here the stamps tell
/// it. The filter also loses a frame whose transform comes from another thread while it is put
/// aside (seen: 1 in 10,000).
template <typename Message>
class PosedFrames {
 public:
  using Pointer = boost::shared_ptr<const Message>;

  struct PosedFrame {
    Pointer message;
    geometry_msgs::Transform pose;  ///< of the ego's base in the map
    std::size_t dropped = 0;        ///< frames before it without a transform
  };

  /// If the ego's poses go back by more than kRestart, the replay was restarted: clears the known
  /// transforms.
  void addTransforms(const tf2_msgs::TFMessage& message, bool is_static) {
    if (is_static) movers_.addFixed(message);
    for (const geometry_msgs::TransformStamped& transform : message.transforms) {
      if (!is_static && movesEgo(transform)) {
        const ros::Time& stamp = transform.header.stamp;
        if (stamp + ros::Duration(kRestart) < newest_pose_) buffer_.clear();
        newest_pose_ = stamp;
      }
      buffer_.setTransform(transform, names::kTf, is_static);
    }
  }

  /// Returns true if a transform of /tf moves the ego, given the /tf_static received so far.
  bool movesEgo(const geometry_msgs::TransformStamped& transform) const {
    return movers_.has(transform);
  }

  /// If the frame is older than the newest waiting one by more than kRestart, the replay was
  /// restarted: drops all waiting frames.
  void addFrame(const Pointer& message) {
    const ros::Time stamp = message->header.stamp + ros::Duration(kRestart);
    if (!waiting_.empty() && stamp < waiting_.back()->header.stamp) waiting_.clear();
    waiting_.push_back(message);
    if (waiting_.size() > kQueue) waiting_.pop_front();
  }

  /// Removes and returns the oldest frame with a known transform; drops the frames before it.
  std::optional<PosedFrame> next() {
    for (std::size_t i = 0; i < waiting_.size(); ++i) {
      const ros::Time stamp = waiting_[i]->header.stamp;
      if (!buffer_.canTransform(names::kMapFrame, names::kBaseFrame, stamp)) continue;
      const auto pose = buffer_.lookupTransform(names::kMapFrame, names::kBaseFrame, stamp);
      PosedFrame frame{waiting_[i], pose.transform, i};
      waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(i) + 1);
      return frame;
    }
    return std::nullopt;
  }

 private:
  static constexpr double kCache = 600.0;      // s of transforms that may come before their frames
  static constexpr std::size_t kQueue = 1000;  // frames that may wait

  EgoMovers movers_;
  tf2::BufferCore buffer_{ros::Duration(kCache)};
  ros::Time newest_pose_;
  std::deque<Pointer> waiting_;
};

}  // namespace forge
