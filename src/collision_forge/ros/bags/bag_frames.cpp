#include "collision_forge/ros/bags/bag_frames.h"

#include <rosbag/view.h>

#include <algorithm>
#include <cstdint>
#include <tuple>

namespace forge {
namespace {

constexpr std::uint32_t kLastSecond = UINT32_MAX - 3600;  // beyond, sums of stamps overflow in tf2

bool isFinite(const geometry_msgs::Vector3& vector) {
  return Eigen::Vector3d(vector.x, vector.y, vector.z).allFinite();
}

/// Returns false for a quaternion without a direction.
bool normalise(geometry_msgs::Quaternion& rotation) {
  Eigen::Vector4d parts(rotation.x, rotation.y, rotation.z, rotation.w);
  parts /= parts.norm();
  std::tie(rotation.x, rotation.y, rotation.z, rotation.w) =
      std::tie(parts.x(), parts.y(), parts.z(), parts.w());
  return parts.allFinite();
}

}  // namespace

std::string frameName(const std::string& frame_id) {
  return frame_id.substr(!frame_id.empty() && frame_id.front() == '/' ? 1 : 0);
}

std::vector<geometry_msgs::TransformStamped> usableTransforms(const tf2_msgs::TFMessage& message) {
  std::vector<geometry_msgs::TransformStamped> usable;
  for (geometry_msgs::TransformStamped transform : message.transforms) {
    transform.header.frame_id = frameName(transform.header.frame_id);
    transform.child_frame_id = frameName(transform.child_frame_id);
    auto& [translation, rotation] = transform.transform;
    if (isFinite(translation) && normalise(rotation) && transform.header.stamp.sec < kLastSecond) {
      usable.push_back(transform);
    }
  }
  return usable;
}

bool BagFrames::add(const geometry_msgs::TransformStamped& transform, bool is_static) {
  const std::string& child = transform.child_frame_id;
  all_.emplace(transform.header.frame_id, child);
  if (!acceptsParent(child, transform.header.frame_id)) return false;
  if (is_static) {
    tf2_msgs::TFMessage fixed;
    fixed.transforms = {transform};
    ego_movers_.addFixed(fixed);
  } else {
    ros::Time& last = stamps_[child];
    if (transform.header.stamp <= last) return false;
    last = transform.header.stamp;
    newest_ = std::max(newest_, last);
  }
  return buffer_.setTransform(transform, names::kTf, is_static);
}

void BagFrames::addPose(const std::string& parent, const std::string& child, const ros::Time& time,
                        const Eigen::Isometry3d& pose) {
  tf2_msgs::TFMessage message;
  geometry_msgs::TransformStamped& transform = message.transforms.emplace_back();
  transform.header.stamp = time;
  transform.header.frame_id = parent;
  transform.child_frame_id = child;
  const Eigen::Quaterniond turn(pose.linear());
  auto& [translation, rotation] = transform.transform;
  std::tie(translation.x, translation.y, translation.z) =
      std::make_tuple(pose.translation().x(), pose.translation().y(), pose.translation().z());
  std::tie(rotation.x, rotation.y, rotation.z, rotation.w) =
      std::make_tuple(turn.x(), turn.y(), turn.z(), turn.w());
  for (const auto& usable : usableTransforms(message)) add(usable, false);
}

bool BagFrames::acceptsParent(const std::string& child, const std::string& parent) {
  const auto [known, is_new] = parents_.try_emplace(child, parent);
  if (is_new || known->second == parent) return true;
  if (leadsToMap(known->second) || !leadsToMap(parent)) return false;
  known->second = parent;
  stamps_.erase(child);
  buffer_.clear();
  return true;
}

bool BagFrames::leadsToMap(std::string frame) const {
  for (std::size_t i = 0; i < parents_.size() && frame != map_frame_; ++i) {
    const auto parent = parents_.find(frame);
    if (parent == parents_.end()) return false;
    frame = parent->second;
  }
  return frame == map_frame_;
}

std::optional<Eigen::Isometry3d> BagFrames::poseOf(const std::string& frame,
                                                   const ros::Time& time) const {
  if (frame == map_frame_) return Eigen::Isometry3d::Identity();
  if (!buffer_.canTransform(map_frame_, frame, time)) return std::nullopt;
  const auto found = buffer_.lookupTransform(map_frame_, frame, time).transform;
  const auto& [x, y, z, w] = found.rotation;
  return Eigen::Translation3d(found.translation.x, found.translation.y, found.translation.z) *
         Eigen::Quaterniond(w, x, y, z);
}

bool BagFrames::isPast(const ros::Time& time) const {
  return newest_.toSec() - time.toSec() > cache_;
}

std::string BagFrames::described() const {
  std::string text;
  for (const auto& [parent, child] : all_) {
    text += (text.empty() ? "" : ", ") + parent + " -> " + child;
  }
  return text.empty() ? "none" : text;
}

void addTransforms(const rosbag::Bag& source, BagFrames& frames,
                   const std::function<tf2_msgs::TFMessage(const tf2_msgs::TFMessage&)>& changed) {
  for (const char* topic : {names::kStaticTf, names::kTf}) {
    const bool is_static = topic == names::kStaticTf;
    for (const rosbag::MessageInstance& instance :
         rosbag::View(source, rosbag::TopicQuery(topic))) {
      const auto message = instance.instantiate<tf2_msgs::TFMessage>();
      if (!message) continue;
      const bool is_changed = !is_static && changed;
      for (const auto& transform : usableTransforms(is_changed ? changed(*message) : *message)) {
        frames.add(transform, is_static);
      }
    }
  }
}

}  // namespace forge
