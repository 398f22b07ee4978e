#pragma once

#include <optional>

#include "collision_forge/base/scene/crash_definition.h"
#include "collision_forge/planner_test/planners/pdm_options.h"
#include "collision_forge/planner_test/trials/crash_scenario.h"

namespace forge {

/// Thresholds for the ego's fault in a contact, as nuPlan defines it.
struct FaultOptions {
  double standstill_speed = 0.05;  ///< m/s; an agent at or below it is stopped; nuPlan
  /// rad, of angleToOther(); an agent beyond it is behind the ego; nuPlan.
  double behind_angle = PdmScoringOptions().behind_angle;
  /// m between the ego's front edge and the other box, at most, for a frontal contact.
  double front_tolerance = 0.01;
  double off_road_share = 0.05;  ///< share 0..1 of the box off the drivable area; above it the ego
                                 ///< is not within one lane; STRIVE
  double lane_radius = 15.0;  ///< m around the middle of the ego's box; lanes within this distance
                              ///< may contain it or make the place a junction
};

/// Kind of contact in nuPlan's classification; the first kind that applies.
enum class ContactCause {
  kStoppedEgo,    ///< the ego is stopped
  kStoppedOther,  ///< the other agent is stopped, or is an object
  kRear,          ///< the other agent's middle is behind the ego: angleToOther() exceeds
                  ///< FaultOptions::behind_angle
  kFront,         ///< the other agent touches the ego's front edge, to front_tolerance
  kLateral,       ///< anything else
};
/// Returns "stopped_ego", "stopped_other", "rear", "front" or "lateral".
const char* toString(ContactCause cause);
/// Returns the value of a name as toString() spells it; nullopt for another name.
std::optional<ContactCause> contactCauseFromString(const std::string& name);

/// State of one of the two agents at contact.
struct ContactSide {
  OrientedBox box;                     ///< at contact, global map frame
  Vector2 velocity = Vector2::Zero();  ///< m/s, global map frame
  bool is_object = false;              ///< static object: counts as stopped whatever its velocity
};

/// Returns the angle (rad, [0, pi]) between the ego's heading and the direction from its rear axle
/// to the other box's middle; 0 is straight ahead. `center_offset`: m from the rear axle to the
/// middle of the ego's box, as in EgoVehicle.
double angleToOther(const OrientedBox& ego, double center_offset, const OrientedBox& other);

/// Returns the kind of a contact. `center_offset` (m) as in angleToOther().
ContactCause causeOf(const ContactSide& ego, double center_offset, const ContactSide& other,
                     const FaultOptions& options);

/// Returns the norm of the relative velocity of the two sides, m/s. In a crash of two equal masses
/// without rebound, the velocity of each changes by half of it.
double impactSpeed(const ContactSide& ego, const ContactSide& other);

/// Returns whether the ego is at fault: kStoppedOther and kFront are its fault, kStoppedEgo and
/// kRear are not, kLateral is unless the ego is within one lane.
bool isAtFault(ContactCause cause, bool is_within_a_lane);

/// As above; derives from the map whether the ego is within one lane: not in several lanes
/// (isInSeveralLanes()) and not off the road by more than `options.off_road_share`. `ego`: its box
/// at contact, global map frame.
bool isAtFault(ContactCause cause, const OrientedBox& ego, const LaneIndex& lanes,
               const FaultOptions& options);

/// Returns whether the box is in several lanes: no lane polygon within `radius` metres of its
/// middle, joined with a successor's, contains all four corners, but one contains some of them.
/// False for a box outside of all lanes and if the map has no polygons.
bool isInSeveralLanes(const OrientedBox& box, const LaneIndex& lanes, double radius);

/// Kind of road at a contact.
enum class ContactPlace {
  kLane,       ///< a lane outside junctions
  kJunction,   ///< not in such a lane, but near a lane or connector of a junction
  kElsewhere,  ///< neither, as a car park
};
/// Returns "lane", "junction" or "elsewhere".
const char* toString(ContactPlace place);
/// Returns the value of a name as toString() spells it; nullopt for another name.
std::optional<ContactPlace> contactPlaceFromString(const std::string& name);

/// Returns the kind of road at `point` (m, global map frame). Lanes and connectors of a junction
/// within `radius` metres count as near.
ContactPlace placeOf(const Vector2& point, const LaneIndex& lanes, double radius);

/// Poses of the ego and the other agent at t0, and their boxes at contact; middle of the box,
/// global map frame.
struct ContactPoses {
  Pose2 ego_now;      ///< at t0
  Pose2 other_now;    ///< at t0, or when the agent was first observed after it
  OrientedBox ego;    ///< at contact
  OrientedBox other;  ///< at contact
  AgentClass other_class = AgentClass::kCar;
};

/// Returns the collision type of a contact by its full definition in `crash`: `requested`, with
/// `turning`, if it applies, else the first of kCollisionTypes that does (with Turning::kAttacker);
/// nullopt if no type applies. kEgo needs a `requested` of mayAskForEgoTurn(); the ego may turn
/// anywhere, also off junctions.
std::optional<CollisionType> typeOf(const ContactPoses& poses, CollisionType requested,
                                    Turning turning, const CrashDefinition& crash,
                                    DrivingSide driving_side);

}  // namespace forge
