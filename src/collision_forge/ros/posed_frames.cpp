#include "collision_forge/ros/posed_frames.h"

#include "collision_forge/ros/topic_names.h"

namespace forge {

void PosedFrames::addTransforms(const tf2_msgs::TFMessage& message, bool is_static) {
  for (const geometry_msgs::TransformStamped& transform : message.transforms) {
    if (transform.child_frame_id == names::kBaseFrame) {
      const ros::Time& stamp = transform.header.stamp;
      if (stamp + ros::Duration(kRestart) < newest_pose_) buffer_.clear();
      newest_pose_ = stamp;
    }
    buffer_.setTransform(transform, names::kTf, is_static);
  }
}

void PosedFrames::addFrame(const collision_forge::AgentArray::ConstPtr& agents) {
  if (!waiting_.empty() && agents->header.stamp < waiting_.back()->header.stamp) waiting_.clear();
  waiting_.push_back(agents);
  if (waiting_.size() > kQueue) waiting_.pop_front();
}

std::optional<PosedFrames::PosedFrame> PosedFrames::next() {
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

}  // namespace forge
