#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <boost/shared_ptr.hpp>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "collision_forge/base/scene/scene_history.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {

/// Detects the transforms of /tf that move the ego: their child is the first frame, going from
/// `base_frame` to its parents, that /tf_static does not fix to its parent; `base_frame` itself
/// before the first addFixed().
class EgoMovers {
 public:
  explicit EgoMovers(std::string base_frame = names::kBaseFrame)
      : base_frame_(std::move(base_frame)), moving_(base_frame_) {}

  /// Adds transforms of /tf_static; they replace earlier parents of the same children.
  void addFixed(const tf2_msgs::TFMessage& message) {
    for (const geometry_msgs::TransformStamped& transform : message.transforms) {
      parents_[transform.child_frame_id] = transform.header.frame_id;
    }
    moving_ = base_frame_;
    for (std::size_t i = 0; i < parents_.size() && parents_.count(moving_) > 0; ++i) {
      moving_ = parents_[moving_];
    }
  }

  /// Returns true if `transform`, of /tf, moves the ego.
  bool has(const geometry_msgs::TransformStamped& transform) const {
    return transform.child_frame_id == moving_;
  }

 private:
  std::string base_frame_;
  std::map<std::string, std::string> parents_;  // by child frame, from /tf_static
  std::string moving_;                          // child frame of the transforms that move the ego
};

/// Pairs messages (any type with a `header`) with the ego's pose at their stamp, in their order.
/// Messages wait until the transform arrives. Not thread-safe.
///
/// Replaces the listener and the message filter of tf2_ros, which lose frames when a replay
/// restarts: the listener detects the restart by /clock, which arrives on a third connection, and
/// the filter drops frames that arrive before their transform. This class detects a restart by the
/// stamps. The filter also loses a frame if its transform arrives in another thread while the frame
/// is queued (measured: 1 in 10,000).
template <typename Message>
class PosedFrames {
 public:
  using Pointer = boost::shared_ptr<const Message>;

  /// A message with the ego's pose at its stamp.
  struct PosedFrame {
    Pointer message;
    geometry_msgs::Transform pose;  ///< base_link in the map frame, interpolated (tf2)
    std::size_t dropped = 0;        ///< number of dropped frames before it, without a transform
  };

  /// Adds transforms of /tf or /tf_static. A pose of the ego that is older than the newest by more
  /// than kRestart means that the replay restarted: all earlier transforms of /tf are dropped, also
  /// earlier elements of `message`; the transforms of /tf_static are kept.
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

  /// Returns true if `transform`, of /tf, moves the ego, given the received /tf_static.
  bool movesEgo(const geometry_msgs::TransformStamped& transform) const {
    return movers_.has(transform);
  }

  /// Queues a frame, not null. If it is older than the newest queued frame by more than kRestart,
  /// the replay restarted: all queued frames are dropped first. A full queue (kQueue) drops its
  /// oldest frame.
  void addFrame(const Pointer& message) {
    const ros::Time stamp = message->header.stamp + ros::Duration(kRestart);
    if (!waiting_.empty() && stamp < waiting_.back()->header.stamp) waiting_.clear();
    waiting_.push_back(message);
    if (waiting_.size() > kQueue) waiting_.pop_front();
  }

  /// Removes and returns the first queued frame whose transform (map to base_link at its stamp,
  /// never extrapolated) is known; drops the frames queued before it. Returns nullopt, and drops
  /// nothing, if there is no such frame.
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
  static constexpr double kCache = 600.0;      // s of transforms that are kept for later frames
  static constexpr std::size_t kQueue = 1000;  // frames that may wait

  EgoMovers movers_;
  tf2::BufferCore buffer_{ros::Duration(kCache)};
  ros::Time newest_pose_;        // stamp of the newest transform that moves the ego
  std::deque<Pointer> waiting_;  // queued frames in the order of addFrame()
};

}  // namespace forge
