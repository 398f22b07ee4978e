#pragma once

#include <map>

#include "collision_forge/base/geometry/oriented_box.h"
#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/base/scene/collision_type.h"

namespace forge {

/// One of the types of config/crash_definition.yaml: bands of |relative heading|, radians.
struct TypeDefinition {
  double min_heading = 0.0;  ///< at first contact
  double max_heading = 0.0;
  double nominal_heading = 0.0;
  double min_approach = 0.0;     ///< now; from any side unless the configuration says otherwise
  double max_approach = 3.1416;  ///< as the files round pi
};
using TypeDefinitions = std::map<CollisionType, TypeDefinition>;

/// What makes a crash one of a type: kFull all that is said below, kAngle the heading at first
/// contact alone.
enum class TypeRules { kFull, kAngle };

/// Which limits of config/vehicle_limits.yaml an attacker keeps: kDrivable those of its class,
/// kStrict those of the strict protocol, the same for all.
enum class LimitSet { kDrivable, kStrict };

/// s; a longer time tolerance would let any time do.
inline constexpr double kMaxTimeTolerance = 60.0;

/// What counts as the crash that is asked for, and what an answer has to promise:
/// config/crash_definition.yaml, unless a request says otherwise.
struct CrashDefinition {
  TypeRules rules = TypeRules::kFull;
  TypeDefinitions types;
  double time_tolerance = 0.0;  ///< s that the contact may come before or after the time asked for
  double min_confidence = 0.0;  ///< an answer that promises less is declined, [0, 1]
  LimitSet limits = LimitSet::kDrivable;
  bool believable = true;  ///< the attacker drives as drivers do until it attacks
};

/// The same as clips of COLLIDE are judged, which have sizes, classes and maps for nobody: the
/// types told by the heading at contact alone, as COLLIDE tells its types apart, by the limits of
/// the strict protocol, whether a driver would do it or not.
CrashDefinition rulesOfClips(CrashDefinition crash);

/// The attacker's heading at first contact is within the type's band.
bool headingFits(double relative_heading, const TypeDefinition& definition);

/// The attacker's heading relative to the ego's now is within the type's approach band: a crossing
/// comes from the side, a left turn across path from the opposite direction.
bool approachFits(double relative_heading_now, const TypeDefinition& definition);

/// How the boxes stand to each other at first contact, beyond the heading band. `offset` is the
/// attacker's box middle in the ego box's frame.
///
/// - rear_end: front meets rear, not flank flank. Either may be the one in front.
/// - lane_change: the attacker's middle is beside the ego's body and it heads towards the ego.
/// - ltap: it turned to its left in right-hand traffic (to its right in left-hand traffic).
/// - opposite_direction, junction_crossing: nothing beyond the heading.
bool contactFits(CollisionType type, const Pose2& offset, const BoxSize& ego,
                 const BoxSize& attacker, DrivingSide driving_side);

}  // namespace forge
