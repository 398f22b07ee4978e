#include "collision_forge/ros/markers/shown_motion.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "collision_forge/ros/messages/conversions.h"

namespace forge {
namespace {

constexpr double kStraight = 1e-4;    // rad/s; slower turns are none
constexpr double kSlowest = 0.5;      // m/s; slower, a yaw's change is noise
constexpr double kFastestTurn = 1.0;  // rad/s

double turnRateBetween(const AgentState& before, const AgentState& last) {
  const double time = last.time - before.time;
  if (time <= 0.0 || time > kMaxGap || last.velocity.norm() < kSlowest) return 0.0;
  const double rate = angleBetween(before.pose.yaw, last.pose.yaw) / time;
  return std::clamp(rate, -kFastestTurn, kFastestTurn);
}

}  // namespace

Pose2 movedOn(const AgentState& state, double turn_rate, double duration) {
  const Vector2& velocity = state.velocity;
  const double turn = turn_rate * duration;
  double along = duration;  // the integrals of cos and sin of the turn
  double across = 0.0;
  if (std::abs(turn_rate) > kStraight) {
    along = std::sin(turn) / turn_rate;
    across = (1.0 - std::cos(turn)) / turn_rate;
  }
  return {state.pose.x + along * velocity.x() - across * velocity.y(),
          state.pose.y + along * velocity.y() + across * velocity.x(),
          wrapAngle(state.pose.yaw + turn)};
}

double lastTurnRate(const collision_forge::AgentTrack& track) {
  if (track.states.size() < 2) return 0.0;
  return turnRateBetween(fromMessage(track.states[track.states.size() - 2]),
                         fromMessage(track.states.back()));
}

Pose2 shownPose(const collision_forge::AgentTrack& track, const ros::Time& now) {
  const AgentState newest = fromMessage(track.states.back());
  const double since = (now - track.states.back().stamp).toSec();
  return movedOn(newest, lastTurnRate(track), std::clamp(since, 0.0, kLongestGuess));
}

std::optional<AgentState> shownState(const Track& track, double now) {
  const auto& states = track.states;
  if (states.empty() || now <= states.back().time) return stateAt(track, now);
  const double since = now - states.back().time;
  if (since > kLongestGuess) return std::nullopt;
  const double turn_rate =
      states.size() < 2 ? 0.0 : turnRateBetween(*std::prev(states.end(), 2), states.back());
  return AgentState{now, movedOn(states.back(), turn_rate, since), states.back().velocity};
}

std::optional<Pose2> drivenPose(const collision_forge::AttackerTrajectory& trajectory,
                                const ros::Time& now) {
  const auto& points = trajectory.points;
  if (points.empty() || now < points.front().stamp) return std::nullopt;
  const auto after =
      std::upper_bound(points.begin(), points.end(), now,
                       [](const ros::Time& time, const auto& point) { return time < point.stamp; });
  if (after == points.end()) return fromMessage(points.back().pose);
  const auto before = std::prev(after);
  const double ratio = (now - before->stamp).toSec() / (after->stamp - before->stamp).toSec();
  return interpolate(fromMessage(before->pose), fromMessage(after->pose), ratio);
}

}  // namespace forge
