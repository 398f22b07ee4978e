#include "collision_forge/ros/messages/conversions.h"

#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "collision_forge/ros/messages/field_values.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {
namespace {

BoxSize fromMessage(const geometry_msgs::Vector3& message) { return {message.x, message.y}; }

/// NaN for a quaternion that is not finite.
template <typename Quaternion>
double yawOf(const Quaternion& q) {
  if (!std::isfinite(q.w + q.x + q.y + q.z)) return std::numeric_limits<double>::quiet_NaN();
  return std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z));
}

AgentClass agentClass(std::uint8_t value, const std::string& id) {
  return enumOf(value, kLastAgentClass, "agent " + id + ": agent_class");
}

/// Returns nullopt for a size without a height.
std::optional<double> heightOf(const geometry_msgs::Vector3& size) {
  return std::isfinite(size.z) && size.z > 0.0 ? std::optional(size.z) : std::nullopt;
}

collision_forge::Tensor toMessage(const DenseTensor& tensor) {
  collision_forge::Tensor message;
  message.shape = tensor.shape;
  message.data = tensor.data;
  return message;
}

/// Throws as fromMessage() of the trajectory.
std::vector<AgentState> pastIn(const collision_forge::AttackerTrajectory& message) {
  const std::string attacker = "attacker " + message.attacker_id + ": ";
  if (message.added == message.past.empty()) {
    throw MessageError(attacker + (message.added ? "added is true, but past is empty"
                                                 : "past is given, but added is false"));
  }
  std::vector<AgentState> past;
  for (const auto& state : message.past) {
    const std::string name = attacker + "past[" + std::to_string(past.size()) + "]";
    past.push_back(forge::fromMessage(state));
    if (!past.back().pose.isFinite() || !past.back().velocity.allFinite()) {
      throw MessageError(name + " is not finite");
    }
    if (past.size() > 1 && past.back().time <= past[past.size() - 2].time) {
      throw MessageError(name + ".stamp is not later than the previous one");
    }
  }
  return past;
}

}  // namespace

void requireMapFrame(const std_msgs::Header& header, const char* topic) {
  if (header.frame_id.empty() || header.frame_id == names::kMapFrame) return;
  throw MessageError(std::string(topic) + ": header.frame_id = \"" + header.frame_id +
                     "\", not \"" + names::kMapFrame + "\"");
}

ros::Time stampOf(double time) {
  constexpr std::uint64_t kMicrosecond = 1000;  // ns
  const ros::Time nearest(time);
  const ros::Time rounded =
      ros::Time().fromNSec((nearest.toNSec() + kMicrosecond / 2) / kMicrosecond * kMicrosecond);
  return rounded.toSec() == time ? rounded : nearest;
}

Pose2 fromMessage(const geometry_msgs::Pose& message) {
  return {message.position.x, message.position.y, yawOf(message.orientation)};
}

Pose2 fromMessage(const geometry_msgs::Pose2D& message) {
  return {message.x, message.y, message.theta};
}

Pose2 fromMessage(const geometry_msgs::Transform& message) {
  return {message.translation.x, message.translation.y, yawOf(message.rotation)};
}

geometry_msgs::Pose toPoseMessage(const Pose2& pose) {
  geometry_msgs::Pose message;
  message.position.x = pose.x;
  message.position.y = pose.y;
  message.orientation.z = std::sin(0.5 * pose.yaw);
  message.orientation.w = std::cos(0.5 * pose.yaw);
  return message;
}

void setPlanar(const Pose2& planar, geometry_msgs::Pose& pose) {
  const double turn = angleBetween(fromMessage(pose).yaw, planar.yaw);
  auto& message = pose.orientation;
  const Eigen::Quaterniond turned = Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()) *
                                    Eigen::Quaterniond(message.w, message.x, message.y, message.z);
  message.w = turned.w();
  message.x = turned.x();
  message.y = turned.y();
  message.z = turned.z();
  pose.position.x = planar.x;
  pose.position.y = planar.y;
}

geometry_msgs::Pose2D toPose2dMessage(const Pose2& pose) {
  geometry_msgs::Pose2D message;
  message.x = pose.x;
  message.y = pose.y;
  message.theta = pose.yaw;
  return message;
}

geometry_msgs::Vector3 toMessage(const BoxSize& size) {
  geometry_msgs::Vector3 message;
  message.x = size.length;
  message.y = size.width;
  return message;
}

std::optional<BoxSize> egoSizeOf(const collision_forge::EgoVehicle& message) {
  const auto isSize = [](double value) { return std::isfinite(value) && value > 0.0; };
  if (!isSize(message.length) || !isSize(message.width)) return std::nullopt;
  return BoxSize{message.length, message.width};
}

TrajectoryPoint fromMessage(const collision_forge::TrajectoryPoint& message) {
  return {message.stamp.toSec(), fromMessage(message.pose), message.speed, message.acceleration,
          message.curvature};
}

collision_forge::TrajectoryPoint toMessage(const TrajectoryPoint& point) {
  collision_forge::TrajectoryPoint message;
  message.stamp = stampOf(point.time);
  message.pose = toPoseMessage(point.pose);
  message.speed = point.speed;
  message.acceleration = point.acceleration;
  message.curvature = point.curvature;
  return message;
}

std::vector<Track> fromMessage(const collision_forge::AgentArray& message) {
  std::vector<Track> agents;
  const double time = message.header.stamp.toSec();
  for (const auto& agent : message.agents) {
    const Vector2 velocity(agent.velocity.x, agent.velocity.y);
    agents.push_back({agent.id,
                      agentClass(agent.agent_class, agent.id),
                      fromMessage(agent.size),
                      {{time, fromMessage(agent.pose), velocity}},
                      heightOf(agent.size)});
  }
  return agents;
}

AgentState fromMessage(const collision_forge::TrackState& message) {
  return {message.stamp.toSec(), fromMessage(message.pose),
          Vector2(message.velocity_x, message.velocity_y)};
}

collision_forge::TrackState toMessage(const AgentState& state) {
  collision_forge::TrackState message;
  message.stamp = stampOf(state.time);
  message.pose = toPose2dMessage(state.pose);
  message.velocity_x = state.velocity.x();
  message.velocity_y = state.velocity.y();
  return message;
}

Track fromMessage(const collision_forge::AgentTrack& message) {
  Track track{message.id,
              agentClass(message.agent_class, message.id),
              fromMessage(message.size),
              {},
              heightOf(message.size)};
  for (const auto& state : message.states) track.states.push_back(fromMessage(state));
  return track;
}

collision_forge::AgentTrack toMessage(const Track& track) {
  collision_forge::AgentTrack message;
  message.id = track.id;
  message.agent_class = static_cast<std::uint8_t>(track.agent_class);
  message.size = toMessage(track.size);
  message.size.z = track.height.value_or(0.0);
  for (const AgentState& state : track.states) message.states.push_back(toMessage(state));
  return message;
}

Future fromMessage(const collision_forge::Future& message) {
  Future future;
  future.ego = fromMessage(message.ego);
  for (const auto& agent : message.agents) future.agents.push_back(fromMessage(agent));
  for (const auto& ego : message.ego_samples) future.ego_samples.push_back(fromMessage(ego));
  return future;
}

collision_forge::Future toMessage(const Future& future) {
  collision_forge::Future message;
  message.ego = toMessage(future.ego);
  for (const Track& agent : future.agents) message.agents.push_back(toMessage(agent));
  for (const Track& ego : future.ego_samples) message.ego_samples.push_back(toMessage(ego));
  return message;
}

Snapshot fromMessage(const collision_forge::SceneSnapshot& message) {
  Snapshot snapshot;
  snapshot.now = message.header.stamp.toSec();
  snapshot.ego = fromMessage(message.ego);
  for (const auto& agent : message.agents) snapshot.agents.push_back(fromMessage(agent));
  return snapshot;
}

collision_forge::SceneSnapshot toMessage(const Snapshot& snapshot) {
  collision_forge::SceneSnapshot message;
  message.header.frame_id = names::kMapFrame;
  message.header.stamp = stampOf(snapshot.now);
  message.ego = toMessage(snapshot.ego);
  for (const Track& agent : snapshot.agents) message.agents.push_back(toMessage(agent));
  return message;
}

collision_forge::EncodedScene toMessage(const Snapshot& snapshot, const SceneEncoding& encoding) {
  collision_forge::EncodedScene message;
  message.snapshot = toMessage(snapshot);
  message.header = message.snapshot.header;
  message.agent_features = toMessage(encoding.agent_features);
  message.agent_mask = toMessage(encoding.agent_mask);
  message.lane_features = toMessage(encoding.lane_features);
  message.lane_mask = toMessage(encoding.lane_mask);
  message.lane_ids = encoding.lane_ids;
  return message;
}

CollisionPattern fromMessage(const collision_forge::CollisionPattern& message) {
  const auto type = collisionTypeFromString(message.collision_type);
  if (!type) throw MessageError("collision_type = \"" + message.collision_type + "\" is unknown");
  CollisionPattern pattern;
  pattern.type = *type;
  pattern.attacker_id = message.attacker_id;
  pattern.time = message.header.stamp.toSec() + message.tta;
  pattern.ego = {fromMessage(message.ego), fromMessage(message.ego_size)};
  pattern.attacker_offset = fromMessage(message.attacker_offset);
  pattern.attacker_speed = message.attacker_speed;
  pattern.tolerance = message.tolerance;
  return pattern;
}

collision_forge::CollisionPattern toMessage(const CollisionPattern& pattern, double now) {
  collision_forge::CollisionPattern message;
  message.header.frame_id = names::kMapFrame;
  message.header.stamp = stampOf(now);
  message.collision_type = toString(pattern.type);
  message.attacker_id = pattern.attacker_id;
  message.tta = pattern.time - now;
  message.ego = toPose2dMessage(pattern.ego.center);
  message.ego_size = toMessage(pattern.ego.size);
  message.attacker_offset = toPose2dMessage(pattern.attacker_offset);
  message.attacker_speed = pattern.attacker_speed;
  message.tolerance = pattern.tolerance;
  return message;
}

ReferencePath fromMessage(const collision_forge::AttackerPath& message) {
  std::vector<Vector2> controls;
  for (const auto& point : message.points) controls.emplace_back(point.x, point.y);
  try {
    return {message.spacing, std::move(controls)};
  } catch (const std::invalid_argument& error) {
    throw MessageError("ways of \"" + message.attacker_id + "\": " + error.what());
  }
}

collision_forge::AttackerPath toMessage(const ReferencePath& way, const std::string& attacker_id) {
  collision_forge::AttackerPath message;
  message.attacker_id = attacker_id;
  message.spacing = way.spacing();
  for (const Vector2& control : way.controls()) {
    geometry_msgs::Point& point = message.points.emplace_back();
    point.x = control.x();
    point.y = control.y();
  }
  return message;
}

AttackerTrajectory fromMessage(const collision_forge::AttackerTrajectory& message) {
  AttackerTrajectory trajectory{message.attacker_id,
                                agentClass(message.agent_class, message.attacker_id),
                                fromMessage(message.size),
                                {},
                                pastIn(message)};
  if (!(trajectory.size.length > 0.0 && trajectory.size.width > 0.0 &&
        std::isfinite(trajectory.size.length) && std::isfinite(trajectory.size.width))) {
    throw MessageError("attacker " + message.attacker_id + ": size is not positive");
  }
  std::vector<TrajectoryPoint>& points = trajectory.points;
  const auto fail = [&](const char* problem) {
    throw MessageError("attacker " + message.attacker_id + ": points[" +
                       std::to_string(points.size() - 1) + problem);
  };
  for (const auto& point : message.points) {
    points.push_back(fromMessage(point));
    const TrajectoryPoint& newest = points.back();
    if (!newest.pose.isFinite() || !std::isfinite(newest.speed) ||
        !std::isfinite(newest.acceleration) || !std::isfinite(newest.curvature)) {
      fail("] is not finite");
    }
    if (points.size() > 1 && newest.time <= points[points.size() - 2].time) {
      fail("].stamp is not later than the previous one");
    }
  }
  return trajectory;
}

collision_forge::AttackerTrajectory toMessage(const AttackerTrajectory& trajectory) {
  collision_forge::AttackerTrajectory message;
  message.header.frame_id = names::kMapFrame;
  if (!trajectory.points.empty()) {
    message.header.stamp = stampOf(trajectory.points.front().time);
  }
  message.attacker_id = trajectory.attacker_id;
  message.agent_class = static_cast<std::uint8_t>(trajectory.agent_class);
  message.size = toMessage(trajectory.size);
  for (const TrajectoryPoint& point : trajectory.points) message.points.push_back(toMessage(point));
  message.added = trajectory.isAdded();
  for (const AgentState& state : trajectory.past) message.past.push_back(toMessage(state));
  return message;
}

Attack fromMessage(const collision_forge::Attack& message) {
  Attack answer;
  answer.pattern = fromMessage(message.pattern);
  answer.miss = {message.miss_distance, message.miss_heading};
  answer.trajectory = fromMessage(message.trajectory);
  for (const collision_forge::SupportVehicle& support : message.supports) {
    answer.supports.push_back(
        {wordIn(support.role, "role", supportRoleFromString), fromMessage(support.motion)});
  }
  answer.effort = message.effort;
  answer.report = fromMessage(message.report);
  return answer;
}

collision_forge::Attack toMessage(const Attack& answer, const std::string& method, double now) {
  collision_forge::Attack message;
  message.header.frame_id = names::kMapFrame;
  message.header.stamp = stampOf(now);
  message.method = method;
  message.pattern = toMessage(answer.pattern, now);
  message.miss_distance = answer.miss.distance;
  message.miss_heading = answer.miss.heading;
  message.trajectory = toMessage(answer.trajectory);
  for (const SupportVehicle& support : answer.supports) {
    collision_forge::SupportVehicle& added = message.supports.emplace_back();
    added.role = toString(support.role);
    added.motion = toMessage(support.motion);
  }
  message.effort = answer.effort;
  message.report = toMessage(answer.report, answer.trajectory.attacker_id, now);
  return message;
}

void setPlans(const std::vector<AttackerPlan>& plans, collision_forge::Attack& message) {
  const AttackerPlan& last = plans.back();
  message.adaptive = true;
  message.phase = toString(last.phase);
  message.decision = last.reason;
  message.decided = stampOf(last.from);
  message.plans = static_cast<std::uint32_t>(plans.size());
  message.report.decision = last.reason;
}

}  // namespace forge
