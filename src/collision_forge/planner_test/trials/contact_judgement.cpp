#include "collision_forge/planner_test/trials/contact_judgement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "collision_forge/base/geometry/enum_words.h"

namespace forge {
namespace {

constexpr EnumWord<ContactCause> kCauseNames[] = {
    {ContactCause::kStoppedEgo, "stopped_ego"},
    {ContactCause::kStoppedOther, "stopped_other"},
    {ContactCause::kRear, "rear"},
    {ContactCause::kFront, "front"},
    {ContactCause::kLateral, "lateral"},
};

constexpr EnumWord<ContactPlace> kPlaceNames[] = {
    {ContactPlace::kLane, "lane"},
    {ContactPlace::kJunction, "junction"},
    {ContactPlace::kElsewhere, "elsewhere"},
};

bool isOfType(const ContactPoses& poses, CollisionType type, Turning turning,
              const CrashDefinition& crash, DrivingSide driving_side) {
  const TypeDefinition definition = bandsOf(type, turning, crash);
  const Pose2 offset = relativeTo(poses.ego.center, poses.other.center);
  const TurnHeadings headings{angleBetween(poses.ego_now.yaw, poses.ego.center.yaw),
                              angleBetween(poses.other_now.yaw, poses.other.center.yaw),
                              offset.yaw};
  if (turning == Turning::kEgo &&
      !egoTurns(type, headings, poses.other_class, definition, driving_side)) {
    return false;
  }
  return headingFits(offset.yaw, definition) &&
         approachFits(angleBetween(poses.ego_now.yaw, poses.other_now.yaw), definition) &&
         contactFits(type, offset, poses.ego.size, poses.other.size, driving_side, turning);
}

}  // namespace

const char* toString(ContactCause cause) { return wordOf(kCauseNames, cause); }

std::optional<ContactCause> contactCauseFromString(const std::string& name) {
  return valueOf(kCauseNames, name);
}

double angleToOther(const OrientedBox& ego, double center_offset, const OrientedBox& other) {
  const Pose2 axle = compose(ego.center, {-center_offset, 0.0, 0.0});
  const Pose2 offset = relativeTo(axle, other.center);
  return std::abs(std::atan2(offset.y, offset.x));
}

static bool stands(const ContactSide& side, const FaultOptions& options) {
  constexpr double kRounding = 1e-15;  // m/s, of the norm of a velocity
  return side.is_object || side.velocity.norm() <= options.standstill_speed + kRounding;
}

ContactCause causeOf(const ContactSide& ego, double center_offset, const ContactSide& other,
                     const FaultOptions& options) {
  if (stands(ego, options)) return ContactCause::kStoppedEgo;
  if (stands(other, options)) return ContactCause::kStoppedOther;
  if (angleToOther(ego.box, center_offset, other.box) > options.behind_angle) {
    return ContactCause::kRear;
  }
  if (distance(frontEdge(ego.box), other.box) <= options.front_tolerance) {
    return ContactCause::kFront;
  }
  return ContactCause::kLateral;
}

double impactSpeed(const ContactSide& ego, const ContactSide& other) {
  return (other.velocity - ego.velocity).norm();
}

bool isAtFault(ContactCause cause, bool is_within_a_lane) {
  switch (cause) {
    case ContactCause::kStoppedEgo:
    case ContactCause::kRear:
      return false;
    case ContactCause::kStoppedOther:
    case ContactCause::kFront:
      return true;
    case ContactCause::kLateral:
      break;
  }
  return !is_within_a_lane;
}

bool isAtFault(ContactCause cause, const OrientedBox& ego, const LaneIndex& lanes,
               const FaultOptions& options) {
  if (cause != ContactCause::kLateral) return isAtFault(cause, true);
  return isAtFault(cause, !isInSeveralLanes(ego, lanes, options.lane_radius) &&
                              lanes.offRoadShare(ego).value_or(0.0) <= options.off_road_share);
}

bool isInSeveralLanes(const OrientedBox& box, const LaneIndex& lanes, double radius) {
  const auto ring = corners(box);
  const auto outside = [&](std::size_t lane, std::vector<Vector2> points) {
    const Polygon outline{lanes.map().lanes[lane].polygon, {}};
    points.erase(std::remove_if(points.begin(), points.end(),
                                [&](const Vector2& point) { return contains(outline, point); }),
                 points.end());
    return points;
  };
  bool is_in_any = false;
  for (const std::size_t lane : lanes.lanesWithin(box.center.position(), radius)) {
    const std::vector<Vector2> rest = outside(lane, {ring.begin(), ring.end()});
    if (rest.size() == ring.size()) continue;
    is_in_any = true;
    if (rest.empty()) return false;
    for (const std::size_t next : lanes.successors(lane)) {
      if (outside(next, rest).empty()) return false;
    }
  }
  return is_in_any;
}

const char* toString(ContactPlace place) { return wordOf(kPlaceNames, place); }

std::optional<ContactPlace> contactPlaceFromString(const std::string& name) {
  return valueOf(kPlaceNames, name);
}

ContactPlace placeOf(const Vector2& point, const LaneIndex& lanes, double radius) {
  ContactPlace place = ContactPlace::kElsewhere;
  for (const std::size_t index : lanes.lanesWithin(point, radius)) {
    const Lane& lane = lanes.map().lanes[index];
    if (lane.is_connector || lane.is_intersection) {
      place = ContactPlace::kJunction;
    } else if (contains(Polygon{lane.polygon, {}}, point)) {
      return ContactPlace::kLane;
    }
  }
  return place;
}

std::optional<CollisionType> typeOf(const ContactPoses& poses, CollisionType requested,
                                    Turning turning, const CrashDefinition& crash,
                                    DrivingSide driving_side) {
  if (isOfType(poses, requested, turning, crash, driving_side)) return requested;
  for (const CollisionType type : kCollisionTypes) {
    if (isOfType(poses, type, Turning::kAttacker, crash, driving_side)) return type;
  }
  return std::nullopt;
}

}  // namespace forge
