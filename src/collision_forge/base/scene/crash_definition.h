#pragma once

#include <map>

#include "collision_forge/base/geometry/oriented_box.h"
#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/base/scene/collision_type.h"
#include "collision_forge/base/scene/track.h"

namespace forge {

/// Bands of the heading difference |attacker's yaw - ego's yaw|, in [0, pi], of one collision type
/// (crash_definition.yaml). Both ends of a band belong to it.
struct TypeDefinition {
  double min_heading = 0.0;  ///< rad, at contact
  double max_heading = 0.0;  ///< rad, at contact
  /// rad, at contact, within the band; collision patterns have this heading.
  double nominal_heading = 0.0;
  double min_approach = 0.0;     ///< rad, at t0; the default band accepts any approach
  double max_approach = 3.1416;  ///< rad, at t0; pi as the files round it
};
/// The definition of each type of kAllCollisionTypes.
using TypeDefinitions = std::map<CollisionType, TypeDefinition>;

/// Which vehicle must turn. kEgo is a condition of the types of mayAskForEgoTurn().
enum class Turning {
  kAttacker,  ///< ltap: the attacker turns across the path of the ego; else no condition
  kEgo        ///< the ego turns across the path of the attacker, see egoTurns()
};

/// Which conditions define a type.
enum class TypeRules {
  kFull,  ///< heading band at contact, approach band at t0, and contactFits()
  kAngle  ///< heading band at contact alone
};

/// Limits of config/vehicle_limits.yaml for the attacker's motion.
enum class LimitSet {
  kDrivable,  ///< limits of the attacker's vehicle class
  kStrict     ///< limits of the strict protocol, equal for all classes
};

/// s, largest valid CrashDefinition::time_tolerance; a longer tolerance would accept almost any
/// contact time.
inline constexpr double kMaxTimeTolerance = 60.0;

/// Conditions that an attack must meet: config/crash_definition.yaml, overridden by fields of the
/// request.
struct CrashDefinition {
  TypeRules rules = TypeRules::kFull;  ///< how `types` are tested
  TypeDefinitions types;               ///< empty until read from the configuration
  TypeDefinition ltap_ego_turns;       ///< instead of types[kLtap] if the ego turns (Turning::kEgo)
  double time_tolerance = 0.0;         ///< s; largest |contact time - (t0 + TTA)|
  double min_confidence = 0.0;         ///< share 0..1; an attack with less confidence is rejected
  LimitSet limits = LimitSet::kDrivable;  ///< vehicle limits that the attacker must keep
  bool believable = true;                 ///< the attacker must drive plausibly until it attacks
};

/// Returns the heading bands of a type. If the ego turns, ltap has the bands ltap_ego_turns, and
/// the other types allow any approach: the directions at t0 say nothing about the contact.
/// Throws std::out_of_range for a type that `crash.types` lacks.
TypeDefinition bandsOf(CollisionType type, Turning turning, const CrashDefinition& crash);

/// Returns `crash` with the rules for COLLIDE clips, which have no sizes, classes or maps: types by
/// the heading at contact alone (as COLLIDE labels them), the strict limits, implausible motion
/// accepted.
CrashDefinition withClipRules(CrashDefinition crash);

/// Returns true if |`relative_heading`| at contact (attacker's yaw minus ego's, rad) is within the
/// type's heading band.
bool headingFits(double relative_heading, const TypeDefinition& definition);

/// Returns true if |`relative_heading_now`| at t0 (attacker's yaw minus ego's, rad) is within the
/// type's approach band: a junction crossing comes from the side, a left turn across path from the
/// opposite direction.
bool approachFits(double relative_heading_now, const TypeDefinition& definition);

/// Returns true if the relative position at contact fits the type. Does not test the heading band.
/// `offset` is the attacker's box centre in the frame of the ego's box centre; `turning` matters
/// for kLtap only.
///
/// - rear_end: the boxes meet front to rear, not side to side; either vehicle may be in front.
/// - lane_change: the attacker's centre is at least half the ego's width to one side of the ego's
///   axis, and its heading points towards that axis.
/// - ltap: `turning` turned left in right-hand traffic, right in left-hand traffic.
/// - sideswipe_same_direction: both touched sides are left or right; angle_same_direction: at least
///   one of them is.
/// - all other types: no further condition.
bool contactFits(CollisionType type, const Pose2& offset, const BoxSize& ego,
                 const BoxSize& attacker, DrivingSide driving_side,
                 Turning turning = Turning::kAttacker);

/// Returns the sign, -1 or 1, of the attacker's relative heading at contact (attacker's yaw minus
/// ego's) in a left turn across path by `turning` (in left-hand traffic, a right turn): -1 if the
/// attacker heads to the ego's right, as a turning attacker does in right-hand traffic.
double ltapSign(Turning turning, DrivingSide driving_side);

/// Changes of heading in an attack, rad, left positive.
struct TurnHeadings {
  double ego_turn = 0.0;          ///< of the ego between t0 and the contact
  double attacker_turn = 0.0;     ///< of the attacker between t0 and the contact
  double relative_heading = 0.0;  ///< attacker's yaw minus ego's at the contact
};

/// Returns true for the types that Turning::kEgo can be asked of: ltap, junction_crossing,
/// angle_same_direction, angle_opposite_direction.
bool mayAskForEgoTurn(CollisionType type);

/// Returns true if the ego is the turning vehicle of an attack of `type`, one of
/// mayAskForEgoTurn():
///
/// - ltap: the ego turns left (in left-hand traffic, right) by at least pi - definition.max_heading
///   (by how much the two directions of such a type differ from opposite ones at least), and by
///   more than the attacker.
/// - the other types: the ego turns by at least 30 degrees to either side and by more than the
///   attacker. Instead of the latter, an `attacker` on foot or on a cycle (isCycle()) moves within
///   30 degrees of the ego's heading at t0 or of its opposite: it crosses the arm of the junction
///   into which the ego turns, as in Euro NCAP's CPTA and CBTA.
bool egoTurns(CollisionType type, const TurnHeadings& headings, AgentClass attacker,
              const TypeDefinition& definition, DrivingSide driving_side);

}  // namespace forge
