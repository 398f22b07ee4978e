#pragma once

#include <optional>

#include "collision_forge/base/scene/crash_definition.h"
#include "collision_forge/planner_test/planners/pdm_options.h"
#include "collision_forge/planner_test/trials/crash_scenario.h"

namespace forge {

/// Who is to blame for a contact, as nuPlan derives it.
struct FaultOptions {
  double standstill_speed = 0.05;                          ///< m/s; slower is stopped; nuPlan
  double behind_angle = PdmScoringOptions().behind_angle;  ///< rad; nuPlan
  double front_tolerance = 0.01;  ///< m between the ego's front edge and the other, for a front one
  double off_road_share = 0.05;  ///< of the box off the drivable area; more is off the road; STRIVE
  double lane_radius = 15.0;     ///< m; lanes that may hold the ego come as near
};

/// How the ego came to touch somebody, as nuPlan tells collisions apart; the first that fits.
enum class ContactCause {
  kStoppedEgo,    ///< the ego stands
  kStoppedOther,  ///< the other stands, or is an object
  kRear,          ///< the other's middle is behind the ego's rear axle
  kFront,         ///< the ego's front edge touches
  kLateral,       ///< anything else
};
const char* toString(ContactCause cause);
std::optional<ContactCause> contactCauseFromString(const std::string& name);

/// One of two at the moment of contact.
struct ContactSide {
  OrientedBox box;
  Vector2 velocity = Vector2::Zero();  ///< m/s, global map frame
  bool is_object = false;              ///< that never moves, whatever its velocity says
};

/// rad in [0, pi], from the ego's heading to the other's middle, seen from the ego's rear axle,
/// `center_offset` metres behind the middle of its box.
double angleToOther(const OrientedBox& ego, double center_offset, const OrientedBox& other);

ContactCause causeOf(const ContactSide& ego, double center_offset, const ContactSide& other,
                     const FaultOptions& options);

/// m/s, norm of the relative velocity; each of two of the same mass is changed by half of it.
double impactSpeed(const ContactSide& ego, const ContactSide& other);

/// The ego is at fault when it touches one that stands or drives its front into one that does not
/// come from behind; for a lateral contact when it is not within one lane.
bool isAtFault(ContactCause cause, bool is_within_a_lane);

/// The same with an ego that is within a lane unless it is in several lanes or partly off the road.
bool isAtFault(ContactCause cause, const OrientedBox& ego, const LaneIndex& lanes,
               const FaultOptions& options);

/// Not all of the box is in one lane: no polygon of a lane near it, with that of a successor, holds
/// its four corners, and one holds some of them. False where the map has no polygons.
bool isInSeveralLanes(const OrientedBox& box, const LaneIndex& lanes, double radius);

/// What road a contact is on.
enum class ContactPlace {
  kLane,       ///< a lane outside junctions
  kJunction,   ///< otherwise near a lane or connector of a junction
  kElsewhere,  ///< anything else
};
/// "lane", "junction", "elsewhere".
const char* toString(ContactPlace place);
std::optional<ContactPlace> contactPlaceFromString(const std::string& name);

/// `radius`: metres within which lanes and connectors are near.
ContactPlace placeOf(const Vector2& point, const LaneIndex& lanes, double radius);

/// The two at the start and at the contact.
struct ContactPoses {
  Pose2 ego_now;
  Pose2 other_now;
  OrientedBox ego;
  OrientedBox other;
};

/// The collision type that the contact is of, by its full definition: `asked` if it fits, else the
/// first of kCollisionTypes that does.
std::optional<CollisionType> typeOf(const ContactPoses& poses, CollisionType asked,
                                    const TypeDefinitions& definitions, DrivingSide driving_side);

}  // namespace forge
