#include "collision_forge/attack/verify/reversing.h"

#include <algorithm>
#include <cmath>

#include "collision_forge/base/scene/number_words.h"

namespace forge {
namespace {

constexpr double kHalfLane = 1.75;     // m
constexpr double kAhead = 8.0;         // m before the front that are no lane
constexpr double kAheadStep = 1.0;     // m
constexpr double kFarthestBay = 18.0;  // m from the meeting
constexpr double kBayStep = 0.25;      // m

bool isOnLane(const Vector2& place, const LaneIndex& lanes) {
  return !lanes.lanesWithin(place, kHalfLane).empty();
}

bool isDriven(const Vector2& place, const LaneIndex& lanes) {
  return lanes.drivable().contains(place) || lanes.walkways().contains(place);
}

}  // namespace

Pose2 turnedRound(Pose2 pose) {
  pose.yaw = wrapAngle(pose.yaw + M_PI);
  return pose;
}

void turnRound(std::vector<TrajectoryPoint>& points) {
  for (TrajectoryPoint& point : points) {
    point.pose = turnedRound(point.pose);
    point.speed = -point.speed;
    point.acceleration = -point.acceleration;
    point.curvature = -point.curvature;
  }
}

DriveLimits reversingLimits(const Track& attacker, const VerificationOptions& options) {
  DriveLimits limits = driveLimitsOf(attacker.agent_class, attacker.size, options.drivable);
  limits.axle_to_middle = -limits.axle_to_middle;
  limits.max_speed = options.drivable.max_reverse_speed;
  return limits;
}

DriveState reversingStateNow(const Track& attacker, const VerificationOptions& options) {
  Motion motion = estimateMotion(attacker);
  motion.pose = turnedRound(motion.pose);
  motion.speed = 0.0;
  return driveStateOf(motion, reversingLimits(attacker, options));
}

bool isInBay(const OrientedBox& box, const LaneIndex& lanes) {
  const auto isOffLanes = [&](const Vector2& place) {
    return lanes.drivable().contains(place) && !lanes.walkways().contains(place) &&
           !isOnLane(place, lanes);
  };
  const auto ends = corners(box);
  const auto places = samplePointsOf(box);
  if (!std::all_of(ends.begin(), ends.end(), isOffLanes) ||
      !std::all_of(places.begin(), places.end(), isOffLanes)) {
    return false;
  }
  for (double ahead = kAheadStep; ahead <= kAhead; ahead += kAheadStep) {
    const Vector2 place = compose(box.center, {0.5 * box.size.length + ahead, 0.0, 0.0}).position();
    if (!lanes.drivable().contains(place)) return true;
    if (isOnLane(place, lanes)) return false;
  }
  return true;
}

std::optional<double> bayBehind(const Pose2& meeting, const BoxSize& size, const LaneIndex& lanes) {
  for (double back = 0.0; back <= kFarthestBay; back += kBayStep) {
    const Pose2 place = compose(meeting, {-back, 0.0, M_PI});
    if (!isDriven(place.position(), lanes)) return std::nullopt;
    if (isInBay({place, size}, lanes)) return back;
  }
  return std::nullopt;
}

std::string implausibleReversing(const std::vector<TrajectoryPoint>& points, const BoxSize& size,
                                 double contact, const LaneIndex& lanes,
                                 const BelievabilityOptions& options) {
  if (!isInBay({points.front().pose, size}, lanes)) {
    return "does not stand in a bay or a drive at t0";
  }
  double off_road = 0.0;
  double count = 0.0;
  for (const TrajectoryPoint& point : points) {
    for (const Vector2& place : samplePointsOf({point.pose, size})) {
      off_road += !isDriven(place, lanes);
      ++count;
    }
    if (point.time >= contact) break;
  }
  if (off_road > options.max_off_road * count) {
    return "is off the road with " + percentText(off_road / count) + " of its box";
  }
  return "";
}

}  // namespace forge
