#include "collision_forge/ros/injection/finite_parts.h"

#include <algorithm>
#include <cmath>

namespace forge {
namespace {

/// Returns true if a point or vector is finite.
template <typename Vector>
bool isFinite(const Vector& vector) {
  return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

bool isFinite(const geometry_msgs::Quaternion& rotation) {
  return std::isfinite(rotation.x) && std::isfinite(rotation.y) && std::isfinite(rotation.z) &&
         std::isfinite(rotation.w);
}

bool isFinite(const geometry_msgs::Pose& pose) {
  return isFinite(pose.position) && isFinite(pose.orientation);
}

bool isFinite(const collision_forge::Agent& agent) {
  return isFinite(agent.pose) && isFinite(agent.size);
}

bool isFinite(const geometry_msgs::TransformStamped& transform) {
  return isFinite(transform.transform.translation) && isFinite(transform.transform.rotation);
}

template <typename Part>
int keepFiniteIn(std::vector<Part>& parts) {
  const auto end =
      std::remove_if(parts.begin(), parts.end(), [](const Part& part) { return !isFinite(part); });
  const auto left_out = static_cast<int>(parts.end() - end);
  parts.erase(end, parts.end());
  return left_out;
}

}  // namespace

int keepFinite(collision_forge::AgentArray& message) {
  int changed = keepFiniteIn(message.agents);
  for (collision_forge::Agent& agent : message.agents) {
    if (isFinite(agent.velocity)) continue;
    agent.velocity = {};
    ++changed;
  }
  return changed;
}

int keepFinite(tf2_msgs::TFMessage& message) { return keepFiniteIn(message.transforms); }

int keepFinite(const nav_msgs::Odometry& message) {
  const auto& twist = message.twist.twist;
  const bool is_finite =
      isFinite(message.pose.pose) && isFinite(twist.linear) && isFinite(twist.angular);
  return is_finite ? 0 : 1;
}

}  // namespace forge
