#include "collision_forge/attack/network/request_features.h"

#include <algorithm>
#include <cmath>

#include "collision_forge/attack/network/feature_scales.h"

namespace forge {
namespace {

constexpr double kLongestTta = 9.0;       // s
constexpr double kCandidatePlace = 40.0;  // m

}  // namespace

Eigen::VectorXf requestFeatures(std::optional<CollisionType> type, double tta) {
  Eigen::VectorXf features = Eigen::VectorXf::Zero(kRequestFeatures);
  for (int i = 0; i < 5; ++i) {
    if (type && *type == kCollisionTypes[i]) features[i] = 1.0F;
  }
  features[5] = static_cast<float>((tta - 0.5) / (kLongestTta - 0.5));
  features[6] = static_cast<float>(std::sqrt(tta) / 3.0);
  features[7] = static_cast<float>(1.0 / (1.0 + tta));
  return features;
}

CandidateNow candidateNow(const Track& observed, const Pose2& ego_now) {
  const AgentState& state = observed.states.back();
  return {relativeTo(ego_now, state.pose), state.velocity.dot(state.pose.heading())};
}

Eigen::VectorXf candidateFeatures(const CandidateNow& candidate, double ego_speed,
                                  const Pose2& ego_at_impact, double tta, CollisionType type) {
  const double speed = candidate.speed;
  const Pose2& now = candidate.pose;
  const Pose2 at_impact = relativeTo(ego_at_impact, now);
  const Vector2 reached = now.position() + tta * speed * now.heading();
  const Pose2 straight = relativeTo(ego_at_impact, {reached.x(), reached.y(), now.yaw});
  const Vector2 way = ego_at_impact.position() - now.position();
  const double needed = way.norm() / tta;
  const double bearing = angleBetween(now.yaw, std::atan2(way.y(), way.x()));
  const double values[19] = {
      clampedTo(now.x / kCandidatePlace, kMaxFeature),
      clampedTo(now.y / kCandidatePlace, kMaxFeature),
      std::cos(now.yaw),
      std::sin(now.yaw),
      speed / kSpeedScale,
      ego_speed / kSpeedScale,
      clampedTo(at_impact.x / kCandidatePlace, kMaxFeature),
      clampedTo(at_impact.y / kCandidatePlace, kMaxFeature),
      std::cos(at_impact.yaw),
      std::sin(at_impact.yaw),
      clampedTo(straight.x / 20.0, kMaxFeature),
      clampedTo(straight.y / 20.0, kMaxFeature),
      std::log1p(std::hypot(straight.x, straight.y)) / 3.0,
      std::min(needed / kSpeedScale, kMaxFeature),
      clampedTo((needed - speed) / kSpeedScale, kMaxFeature),
      clampedTo((needed - speed) / tta / kAccelerationScale, kMaxFeature) / 2.0,
      std::cos(bearing),
      std::sin(bearing),
      tta / kLongestTta};
  Eigen::VectorXf features = Eigen::VectorXf::Zero(kCandidateFeatures);
  for (int i = 0; i < 19; ++i) features[i] = static_cast<float>(values[i]);
  for (int i = 0; i < 5; ++i) {
    if (type == kCollisionTypes[i]) features[19 + i] = 1.0F;
  }
  return features;
}

}  // namespace forge
