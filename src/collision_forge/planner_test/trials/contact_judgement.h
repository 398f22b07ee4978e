#pragma once

#include <optional>

#include "collision_forge/base/scene/crash_definition.h"
#include "collision_forge/planner_test/planners/pdm_options.h"
#include "collision_forge/planner_test/trials/crash_scenario.h"

namespace forge {

/// Thresholds for the ego's fault in a contact, as nuPlan defines it.
struct FaultOptions {
  double standstill_speed = 0.05;  ///< m/s; an agent below it is stopped; nuPlan
  double behind_angle = PdmScoringOptions().behind_angle;  ///< rad; nuPlan
  double front_tolerance =
      0.01;  ///< m between the ego's front edge and the other box, for a frontal contact
  double off_road_share = 0.05;  ///< share 0..1 of the box off the drivable area; above it the ego
                                 ///< is off the road; STRIVE
  double lane_radius = 15.0;     ///< m; lanes within this distance may contain the ego
};

/// Kind of contact in nuPlan's classification; the first kind that applies.
enum class ContactCause {
  kStoppedEgo,    ///< the ego is stopped
  kStoppedOther,  ///< the other agent is stopped, or is an object
  kRear,          ///< the other agent's middle is behind the ego's rear axle
  kFront,         ///< the other agent touches the ego's front edge
  kLateral,       ///< anything else
};
/// Returns the name in results.jsonl.
const char* toString(ContactCause cause);
/// Returns the value of a name as toString() spells it; nullopt for another name.
std::optional<ContactCause> contactCauseFromString(const std::string& name);

/// State of one of the two agents at contact.
struct ContactSide {
  OrientedBox box;
  Vector2 velocity = Vector2::Zero();  ///< m/s, global map frame
  bool is_object = false;              ///< static object: counts as stopped whatever its velocity
};

/// Returns the angle (rad, [0, pi]) between the ego's heading and the direction from its rear axle
/// to the other box's middle. `center_offset`: m from the rear axle to the middle of the ego's box.
double angleToOther(const OrientedBox& ego, double center_offset, const OrientedBox& other);

/// Classifies a contact. `center_offset` (m) as in EgoVehicle.
ContactCause causeOf(const ContactSide& ego, double center_offset, const ContactSide& other,
                     const FaultOptions& options);

/// Returns the norm of the relative velocity, m/s. In a crash of two equal masses the speed of each
/// changes by half of it.
double impactSpeed(const ContactSide& ego, const ContactSide& other);

/// Returns whether the ego is at fault: it touches a stopped agent, or its front hits an agent that
/// is not coming from behind, or a lateral contact occurs while it is not within one lane.
bool isAtFault(ContactCause cause, bool is_within_a_lane);

/// As above; derives from the map whether the ego is within one lane: not in several lanes and not
/// partly off the road.
bool isAtFault(ContactCause cause, const OrientedBox& ego, const LaneIndex& lanes,
               const FaultOptions& options);

/// Returns whether the box is in several lanes: no lane polygon within `radius` metres, joined with
/// a successor's, contains all four corners, but one contains some of them. False if the map has no
/// polygons.
bool isInSeveralLanes(const OrientedBox& box, const LaneIndex& lanes, double radius);

/// Kind of road at a contact.
enum class ContactPlace {
  kLane,       ///< a lane outside junctions
  kJunction,   ///< otherwise near a lane or connector of a junction
  kElsewhere,  ///< anything else
};
/// Returns "lane", "junction" or "elsewhere".
const char* toString(ContactPlace place);
/// Returns the value of a name as toString() spells it; nullopt for another name.
std::optional<ContactPlace> contactPlaceFromString(const std::string& name);

/// Returns the kind of road at `point`. Lanes and connectors within `radius` metres count as near.
ContactPlace placeOf(const Vector2& point, const LaneIndex& lanes, double radius);

/// Poses of the ego and the other agent at t0, and their boxes at contact.
struct ContactPoses {
  Pose2 ego_now;
  Pose2 other_now;
  OrientedBox ego;
  OrientedBox other;
};

/// Returns the collision type of a contact by its full definition in `crash`: `requested` (kLtap
/// with `turning`) if it applies, else the first of kCollisionTypes that does; empty if none does.
std::optional<CollisionType> typeOf(const ContactPoses& poses, CollisionType requested,
                                    Turning turning, const CrashDefinition& crash,
                                    DrivingSide driving_side);

}  // namespace forge
