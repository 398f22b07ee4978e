#pragma once

#include <map>

#include "collision_forge/base/geometry/oriented_box.h"
#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/base/scene/collision_type.h"

namespace forge {

/// Bands of the heading difference |attacker - ego| of one collision type (crash_definition.yaml).
struct TypeDefinition {
  double min_heading = 0.0;      ///< rad, at contact
  double max_heading = 0.0;      ///< rad, at contact
  double nominal_heading = 0.0;  ///< rad, at contact; used for the collision pattern
  double min_approach = 0.0;     ///< rad, at t0; the default band accepts any approach
  double max_approach = 3.1416;  ///< rad, at t0; pi as the files round it
};
using TypeDefinitions = std::map<CollisionType, TypeDefinition>;

/// The vehicle that turns in a left turn across path.
enum class Turning { kAttacker, kEgo };

/// Which conditions define a type: kFull the heading and approach bands and contactFits(), kAngle
/// the heading band at contact alone.
enum class TypeRules { kFull, kAngle };

/// Limits of config/vehicle_limits.yaml for an attacker: kDrivable by its vehicle class, kStrict
/// the strict protocol's limits, equal for all classes.
enum class LimitSet { kDrivable, kStrict };

/// s; a longer tolerance would accept almost any contact time.
inline constexpr double kMaxTimeTolerance = 60.0;

/// Conditions that an attack must meet: config/crash_definition.yaml, overridden by fields of the
/// request.
struct CrashDefinition {
  TypeRules rules = TypeRules::kFull;
  TypeDefinitions types;
  TypeDefinition ltap_ego_turns;  ///< of CollisionType::kLtap with Turning::kEgo
  double time_tolerance = 0.0;    ///< s; largest |contact time - requested time|
  double min_confidence = 0.0;    ///< share 0..1; an attack with less confidence is rejected
  LimitSet limits = LimitSet::kDrivable;
  bool believable = true;  ///< the attacker must drive plausibly until it attacks
};

/// Returns `crash` with the rules for COLLIDE clips, which have no sizes, classes or maps: types by
/// the heading at contact alone (as COLLIDE labels them), the strict limits, implausible motion
/// accepted.
CrashDefinition withClipRules(CrashDefinition crash);

/// Returns true if |`relative_heading`| at contact (rad) is within the type's heading band.
bool headingFits(double relative_heading, const TypeDefinition& definition);

/// Returns true if |`relative_heading_now`| at t0 (rad) is within the type's approach band: a
/// junction crossing comes from the side, a left turn across path from the opposite direction.
bool approachFits(double relative_heading_now, const TypeDefinition& definition);

/// Returns true if the relative position at contact fits the type, beyond the heading band.
/// `offset` is the attacker's box centre in the frame of the ego's box centre.
///
/// - rear_end: the boxes meet front to rear, not side to side; either vehicle may be in front.
/// - lane_change: the attacker's centre is beside the ego and its heading points towards the ego.
/// - ltap: `turning` turned left in right-hand traffic, right in left-hand traffic.
/// - sideswipe_same_direction: the touched sides are left or right; angle_same_direction: one is.
/// - all other types: no further condition.
bool contactFits(CollisionType type, const Pose2& offset, const BoxSize& ego,
                 const BoxSize& attacker, DrivingSide driving_side,
                 Turning turning = Turning::kAttacker);

/// Returns the sign of the attacker's relative heading at contact that a left turn across path by
/// `turning` has (in left-hand traffic, a right turn): -1 if the attacker heads to the ego's right.
double ltapSign(Turning turning, DrivingSide driving_side);

/// Returns true if the ego's change of heading (rad, left positive) between t0 and the contact
/// makes it the turning vehicle of a left turn across path: to the left (in left-hand traffic, to
/// the right), by at least the angle that `definition` leaves to the opposite direction, and by
/// more than the attacker's change of heading `attacker_turn` (rad).
bool egoTurns(double ego_turn, double attacker_turn, const TypeDefinition& definition,
              DrivingSide driving_side);

}  // namespace forge
