#pragma once

#include <optional>
#include <string>

#include "collision_forge/base/scene/collision_request.h"

namespace forge {

/// Value of departure_time for an attacker that does not depart.
inline constexpr double kNoDeparture = -1.0;
inline constexpr double kDepartureSpeed = 0.02;  ///< m/s; a slower attacker stands

/// Quantities of an attack that a request can constrain with CollisionRequest's fields of the same
/// names; see measuredConditions(). The contact is the first touch of the boxes; poses are box
/// centres. Speeds are along the attacker's heading.
struct ContactConditions {
  double attacker_speed = 0.0;  ///< m/s, speed of the attacker at contact
  double deceleration = 0.0;    ///< m/s2 of the attacker, mean over the last kBrakedFor seconds
                                ///< before the contact; negative if it accelerates
  double gap = 0.0;      ///< m at t0: distance of the box centres of ego and attacker minus half of
                         ///< both lengths; 0 if that is negative
  double headway = 0.0;  ///< s at t0: `gap` over the speed of the vehicle behind (the ego, if the
                         ///< attacker is ahead of it); at most kNoHeadway
  /// m/s at contact, of the attacker across the ego's heading, to either side; >= 0.
  double lateral_speed = 0.0;
  /// Middle of the attacker's touched side across the ego's front, as a share of the ego's width: 0
  /// at the left edge of the front, 1 at its right edge, beyond these outside. Only a contact with
  /// the ego's front has a location that a request accepts.
  double impact_location = 0.0;
  /// s after t0 at which an attacker that stands at t0 starts to move; kNoDeparture if it moves at
  /// t0 or stands at the contact.
  double departure_time = kNoDeparture;
  /// kLeft or kRight: the side of the ego's pose at contact on which the attacker's box centre was
  /// kSideBefore seconds earlier, or at t0 if that is later.
  Side from_side = Side::kLeft;
  /// s before the contact from which on the ego sees the attacker without a break; at most the time
  /// since t0. See sightOf().
  double visible_for = 0.0;
  /// Kind of vehicle that hid the attacker until the ego saw it; empty if it was visible since t0,
  /// or if another agent hid it.
  std::optional<Hider> hidden_by = {};
  std::string hidden_by_id = {};  ///< id of the agent that hid it; empty if it was visible since t0
};

inline constexpr double kBrakedFor = 0.5;     ///< s before the contact; see `deceleration`
inline constexpr double kSideBefore = 1.0;    ///< s before the contact; see `from_side`
inline constexpr double kNoHeadway = 1000.0;  ///< s, headway of a vehicle behind that stands
inline constexpr double kMaxLocation = 1.0;   ///< largest distance of impact_location beyond either
                                              ///< edge of the front, as a share of the width

/// A field of CollisionRequest that is a range of a field of ContactConditions.
struct RangeControl {
  const char* name;  ///< name of both fields, also in files and messages
  const char* unit;  ///< unit of the range, for people
  std::optional<Range> CollisionRequest::*asked;  ///< the requested range; empty: any value
  double ContactConditions::*measured;            ///< the value that must be in the range
  double least;                                   ///< smallest `min` of a valid range
  double most;                                    ///< greatest `max` of a valid range
  const char* meaning;  ///< description of the quantity, for the help of an option
};

/// All range controls, in the order of the fields.
inline constexpr RangeControl kRangeControls[] = {
    {"attacker_speed", "m/s", &CollisionRequest::attacker_speed, &ContactConditions::attacker_speed,
     0.0, 100.0, "speed of the attacker at contact"},
    {"deceleration", "m/s2", &CollisionRequest::deceleration, &ContactConditions::deceleration, 0.0,
     20.0, "deceleration of the attacker, mean over the last 0.5 s before the contact"},
    {"gap", "m", &CollisionRequest::gap, &ContactConditions::gap, 0.0, 1000.0,
     "gap between attacker and ego at t0: distance of the centres minus half of both lengths"},
    {"headway", "s", &CollisionRequest::headway, &ContactConditions::headway, 0.0, kNoHeadway,
     "headway at t0: gap over the speed of the vehicle behind"},
    {"lateral_speed", "m/s", &CollisionRequest::lateral_speed, &ContactConditions::lateral_speed,
     0.0, 100.0, "speed of the attacker across the ego's heading at contact"},
    {"impact_location", "of the ego's width", &CollisionRequest::impact_location,
     &ContactConditions::impact_location, -kMaxLocation, 1.0 + kMaxLocation,
     "place on the ego's front that the middle of the attacker's touched side meets: share of the "
     "ego's width, 0 at the left edge"},
    {"departure_time", "s", &CollisionRequest::departure_time, &ContactConditions::departure_time,
     0.0, 100.0, "time after t0 at which the standing attacker starts to move"},
    {"visible_for", "s", &CollisionRequest::visible_for, &ContactConditions::visible_for, 0.0,
     100.0, "time before the contact from which on the ego sees the attacker, since t0 at most"},
};

/// Returns the element of kRangeControls with a name, or null.
const RangeControl* rangeControl(const std::string& name);

/// Returns the name of a control's option on the command line, without dashes before it: '-'
/// replaces '_' ("attacker-speed").
std::string optionName(const std::string& control);

/// Returns true if the request sets one of kRangeControls, `from_side` or `hidden_by`.
bool asksForConditions(const CollisionRequest& request);

}  // namespace forge
