#include "collision_forge/attack/verify/measured_conditions.h"

#include <algorithm>
#include <cmath>

#include "collision_forge/attack/verify/visibility.h"

namespace forge {
namespace {

constexpr double kStandstill = 1e-6;   // m/s
constexpr double kMicroseconds = 1e6;  // per s; clocks of recordings are not exact beyond

/// Returns the middle of a side of a box, in the frame of the box centre.
Vector2 middleOf(Side side, const BoxSize& size) {
  switch (side) {
    case Side::kFront:
      return {0.5 * size.length, 0.0};
    case Side::kRear:
      return {-0.5 * size.length, 0.0};
    case Side::kLeft:
      return {0.0, 0.5 * size.width};
    case Side::kRight:
      return {0.0, -0.5 * size.width};
  }
  return Vector2::Zero();
}

/// Returns ContactConditions::departure_time.
double departureTime(const std::vector<TrajectoryPoint>& points, double contact) {
  const auto moves = [](const TrajectoryPoint& point) {
    return std::abs(point.speed) > kDepartureSpeed;
  };
  const auto first = std::find_if(points.begin(), points.end(), moves);
  if (first == points.begin() || first == points.end() || first->time > contact) {
    return kNoDeparture;
  }
  const double departure = std::prev(first)->time - points.front().time;
  return std::round(departure * kMicroseconds) / kMicroseconds;
}

}  // namespace

void measureStart(const AgentState& ego, const BoxSize& ego_size, const AgentState& attacker,
                  const BoxSize& attacker_size, ContactConditions& measured) {
  const Vector2 apart = relativeTo(ego.pose, attacker.pose).position();
  measured.gap = std::max(0.0, apart.norm() - 0.5 * (ego_size.length + attacker_size.length));
  const double behind = apart.x() > 0.0 ? ego.velocity.norm() : attacker.velocity.norm();
  measured.headway = std::min(kNoHeadway, measured.gap / std::max(behind, kStandstill));
}

ContactConditions measuredConditions(const AttackerTrajectory& trajectory,
                                     const CollisionReport& report, const Future& future) {
  const Track& ego = future.ego;
  ContactConditions measured;
  const double contact = report.contact_time;
  measured.attacker_speed = std::abs(pointAt(trajectory.points, contact).speed);
  const double begin = std::max(contact - kBrakedFor, trajectory.points.front().time);
  if (contact > begin) {
    measured.deceleration =
        (std::abs(pointAt(trajectory.points, begin).speed) - measured.attacker_speed) /
        (contact - begin);
  }
  measured.lateral_speed = measured.attacker_speed * std::abs(std::sin(report.relative_heading));
  const Vector2 side = middleOf(report.attacker_side, trajectory.size);
  const Pose2 touched = compose(report.attacker_at_contact, {side.x(), side.y(), 0.0});
  const Pose2 place = relativeTo(report.ego_at_contact, touched);
  measured.impact_location = 0.5 - place.y / ego.size.width;
  const Pose2 earlier =
      relativeTo(report.ego_at_contact, poseAt(trajectory, contact - kSideBefore));
  measured.from_side = earlier.y > 0.0 ? Side::kLeft : Side::kRight;
  const TrajectoryPoint& start = trajectory.points.front();
  const AgentState own = stateAt(ego, start.time).value_or(ego.states.front());
  measureStart(own, ego.size, {start.time, start.pose, start.speed * start.pose.heading()},
               trajectory.size, measured);
  measured.departure_time = departureTime(trajectory.points, contact);
  const Sight sight = sightOf(trajectory, future, contact);
  measured.visible_for = contact - sight.seen_from;
  measured.hidden_by = sight.hidden_by;
  measured.hidden_by_id = sight.hidden_by_id;
  return measured;
}

}  // namespace forge
