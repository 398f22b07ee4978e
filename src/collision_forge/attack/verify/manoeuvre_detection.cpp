#include "collision_forge/attack/verify/manoeuvre_detection.h"

#include <algorithm>
#include <cmath>

#include "collision_forge/base/scene/request_words.h"

namespace forge {
namespace {

constexpr double kStanding = 0.5;  // m/s
constexpr double kBraking = 1.0;   // m/s2; a smaller deceleration is not braking
constexpr double kClosing = 0.5;   // m/s
constexpr double kOffset = 0.3;    // m from the original lane offset
constexpr double kOwnWay = 0.7;    // m of offset change up to which the attacker stays in its lane
constexpr double kParked =
    1.0;  // m from the lane's middle; a vehicle that stands nearer is in traffic, not parked
constexpr double kTurning = 0.5;  // rad; a smaller turn is straight on
constexpr double kJunctionTurn =
    0.26;  // rad off the path along its lane in a junction; a smaller one is none
constexpr double kBend = 0.02;   // 1/m; the turn starts above this curvature
constexpr double kAhead = 40.0;  // m within which a vehicle ahead counts as overtaken
constexpr double kBeside = 1.5;  // m from a path within which a vehicle is on it
constexpr double kWay = 200.0;   // m of the attacker's lane ahead
constexpr double kBesideEgo =
    0.7854;  // rad at the start; a greater relative heading is no lane beside
constexpr double kOncoming = 2.3562;     // rad at the start; a greater relative heading is oncoming
constexpr double kLaneDistance = 2.5;    // m from its middle
constexpr double kLaneHeading = 0.7854;  // rad

/// The trajectory points in the last kManoeuvreWindow seconds before the contact.
class Window {
 public:
  Window(const AttackerTrajectory& trajectory, double contact) {
    for (const TrajectoryPoint& point : trajectory.points) {
      if (point.time >= contact - kManoeuvreWindow && point.time <= contact) {
        points_.push_back(&point);
      }
    }
    if (points_.empty()) points_.push_back(&trajectory.points.front());
  }

  const TrajectoryPoint& first() const { return *points_.front(); }
  const TrajectoryPoint& last() const { return *points_.back(); }

  /// Returns the start time of the interval up to the contact in which `is_so` holds; the last
  /// point's time if it does not hold there.
  template <typename IsSo>
  double since(const IsSo& is_so) const {
    std::size_t i = points_.size();
    while (i > 0 && is_so(*points_[i - 1])) --i;
    return points_[std::min(i, points_.size() - 1)]->time;
  }

  /// Returns the time of the first point for which `is_so` holds, else of the first point.
  template <typename IsSo>
  double first(const IsSo& is_so) const {
    const auto found = std::find_if(points_.begin(), points_.end(),
                                    [&](const TrajectoryPoint* point) { return is_so(*point); });
    return found == points_.end() ? first().time : (*found)->time;
  }

 private:
  std::vector<const TrajectoryPoint*> points_;
};

DetectedManoeuvre detectRearEnd(const Window& window, const CollisionReport& report,
                                const Track& ego) {
  const auto closes = [&](const TrajectoryPoint& point) {
    const auto state = stateAt(ego, point.time);
    if (!state) return false;
    const double difference = point.speed - state->velocity.dot(state->pose.heading());
    return std::abs(difference) > kClosing;
  };
  const double since = window.since(closes);
  if (report.ego_side != Side::kFront) return {Manoeuvre::kFollowerCloses, since};
  if (window.last().speed < kStanding && window.first().speed < kStanding) {
    return {Manoeuvre::kLeadStopped, window.first().time};
  }
  const auto brakes = [](const TrajectoryPoint& point) { return point.acceleration < -kBraking; };
  if (brakes(window.last())) return {Manoeuvre::kLeadBrakes, window.since(brakes)};
  if (window.last().speed < kStanding) {
    return {Manoeuvre::kLeadStopped,
            window.since([](const TrajectoryPoint& point) { return point.speed < kStanding; })};
  }
  return {Manoeuvre::kLeadSlow, since};
}

/// Returns the path ahead along the attacker's lane at the start of the window; empty if it is on
/// no lane.
std::optional<Polyline> wayOf(const Window& window, const LaneIndex& lanes) {
  const auto matches = lanes.lanesNear(window.first().pose, kLaneDistance, kLaneHeading);
  if (matches.empty()) return std::nullopt;
  return lanes.pathAhead(matches.front().lane, matches.front().projection.arc_length, kWay);
}

bool isBehindSomebody(const Polyline& way, const Pose2& pose, double time, const Future& future,
                      const std::string& attacker) {
  const double along = way.project(pose.position()).arc_length;
  return std::any_of(future.agents.begin(), future.agents.end(), [&](const Track& agent) {
    if (agent.id == attacker) return false;
    const auto state = stateAt(agent, time);
    if (!state) return false;
    const PolylineProjection place = way.project(state->pose.position());
    return place.distance < kBeside && place.arc_length > along &&
           place.arc_length < along + kAhead;
  });
}

DetectedManoeuvre detectDeparture(const Window& window, const AttackerTrajectory& trajectory,
                                  const VerificationInput& input,
                                  const VerificationOptions& options) {
  const bool is_lane_change = input.request.type != CollisionType::kOppositeDirection &&
                              input.request.type != CollisionType::kAngleOppositeDirection;
  const bool stands = window.first().speed < kStanding;
  const auto moves = [](const TrajectoryPoint& point) { return point.speed >= kStanding; };
  const auto way = wayOf(window, input.lanes);
  if (!way) {
    if (is_lane_change) {
      if (stands) return {Manoeuvre::kPullOut, window.since(moves)};
      return {Manoeuvre::kCutIn, window.first().time};
    }
    const bool is_wrong =
        input.lanes.grid().isWrongWay(window.first().pose, options.believability.lane_distance);
    return {is_wrong ? Manoeuvre::kWrongWay : Manoeuvre::kCentreLineCrossing, window.first().time};
  }
  const auto offset = [&](const TrajectoryPoint& point) {
    return relativeTo(way->poseAt(way->project(point.pose.position()).arc_length), point.pose).y;
  };
  const double kept = offset(window.first());
  const double begin = window.since(
      [&](const TrajectoryPoint& point) { return std::abs(offset(point) - kept) > kOffset; });
  if (is_lane_change && stands && std::abs(kept) > kParked) {
    return {Manoeuvre::kPullOut, window.since(moves)};
  }
  if (is_lane_change) {
    if (std::abs(offset(window.last()) - kept) > kOwnWay) return {Manoeuvre::kCutIn, begin};
    const auto ego = stateAt(input.future.ego, window.first().time);
    // The path starts at the attacker; the ego may be behind its start.
    const bool is_beside = ego && std::abs(way->project(ego->pose.position()).lateral) < kBeside;
    return {is_beside ? Manoeuvre::kDrift : Manoeuvre::kMerge, begin};
  }
  const bool overtakes = isBehindSomebody(*way, poseAt(trajectory, begin), begin, input.future,
                                          trajectory.attacker_id);
  return {overtakes ? Manoeuvre::kOvertaking : Manoeuvre::kCentreLineCrossing, begin};
}

bool isAtJunction(const TrajectoryPoint& point, const VerificationInput& input,
                  const VerificationOptions& options) {
  const auto matches = input.lanes.lanesNear(point.pose, options.believability.lane_distance,
                                             options.believability.lane_heading);
  if (matches.empty()) return false;
  const Lane& lane = input.lanes.map().lanes[matches.front().lane];
  return lane.is_intersection || lane.is_connector;
}

DetectedManoeuvre detectCrossing(const Window& window, const VerificationInput& input,
                                 const VerificationOptions& options) {
  if (window.last().speed < 0.0) {
    return {Manoeuvre::kBackOut,
            window.since([](const TrajectoryPoint& point) { return point.speed <= -kStanding; })};
  }
  const auto atJunction = [&](const TrajectoryPoint& point) {
    return isAtJunction(point, input, options);
  };
  const bool is_marked = atJunction(window.last());
  const double begin =
      is_marked ? window.first(atJunction) : window.since([](const TrajectoryPoint& point) {
        return std::abs(point.curvature) > kBend;
      });
  if (input.request.type == CollisionType::kLtap) {
    const bool ego_turns = input.request.turning == Turning::kEgo;
    return {ego_turns ? Manoeuvre::kStraightCrossing : Manoeuvre::kTurnAcrossPath, begin};
  }
  const double turn = std::abs(angleBetween(window.first().pose.yaw, window.last().pose.yaw));
  return {turn > kTurning ? Manoeuvre::kTurnIntoPath : Manoeuvre::kStraightCrossing, begin};
}

/// Directions at the contact; the path is the one along the attacker's lane at the start of the
/// window.
struct DirectionAtContact {
  double path = 0.0;  ///< rad, absolute, of the path relative to the ego
  double lean = 0.0;  ///< rad, absolute, of the attacker relative to the path
};

DirectionAtContact directionAtContact(const Window& window, const CollisionReport& report,
                                      const LaneIndex& lanes) {
  const Pose2& pose = window.last().pose;
  const auto way = wayOf(window, lanes);
  const double yaw =
      way ? way->poseAt(way->project(pose.position()).arc_length).yaw : window.first().pose.yaw;
  return {std::abs(angleBetween(report.ego_at_contact.yaw, yaw)),
          std::abs(angleBetween(yaw, pose.yaw))};
}

/// Classifies an attack of an angle type: as a turn off or a departure from the path along the
/// attacker's lane if that path is oncoming or leads beside the ego, else as a crossing.
DetectedManoeuvre detectAngle(const Window& window, const AttackerTrajectory& trajectory,
                              const CollisionReport& report, const VerificationInput& input,
                              const VerificationOptions& options) {
  const DetectedManoeuvre crossing = detectCrossing(window, input, options);
  const DirectionAtContact direction = directionAtContact(window, report, input.lanes);
  const bool is_oncoming = input.request.type == CollisionType::kAngleOppositeDirection;
  const auto ego = stateAt(input.future.ego, window.first().time);
  const double from = std::abs(
      angleBetween(ego ? ego->pose.yaw : report.ego_at_contact.yaw, window.first().pose.yaw));
  if (is_oncoming ? direction.path < kOncoming : from > kBesideEgo) return crossing;
  const DetectedManoeuvre departure = detectDeparture(window, trajectory, input, options);
  if (departure.manoeuvre == Manoeuvre::kPullOut) return departure;
  const bool is_at_junction = isAtJunction(window.last(), input, options);
  if (direction.lean >= (is_at_junction ? kJunctionTurn : kTurning)) {
    return {is_oncoming ? Manoeuvre::kTurnAcrossPath : Manoeuvre::kSameDirectionTurn,
            crossing.begin};
  }
  const double from_path = is_oncoming ? M_PI - direction.path : direction.path;
  const bool leaves = direction.lean > from_path;  // else the ego makes most of the angle
  if (leaves && isManoeuvreOf(departure.manoeuvre, input.request.type)) return departure;
  return {Manoeuvre::kStraightCrossing, crossing.begin};
}

}  // namespace

DetectedManoeuvre detectManoeuvre(const AttackerTrajectory& trajectory,
                                  const CollisionReport& report, const VerificationInput& input,
                                  const VerificationOptions& options) {
  const Window window(trajectory, report.contact_time);
  switch (input.request.type) {
    case CollisionType::kRearEnd:
      return detectRearEnd(window, report, input.future.ego);
    case CollisionType::kLaneChange:
    case CollisionType::kOppositeDirection:
    case CollisionType::kSideswipeSameDirection:
      return detectDeparture(window, trajectory, input, options);
    case CollisionType::kAngleSameDirection:
    case CollisionType::kAngleOppositeDirection:
      return detectAngle(window, trajectory, report, input, options);
    case CollisionType::kJunctionCrossing:
    case CollisionType::kLtap:
    case CollisionType::kAny:
      return detectCrossing(window, input, options);
  }
  return {};
}

}  // namespace forge
