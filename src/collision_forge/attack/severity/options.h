#pragma once

#include <array>
#include <string>

#include "collision_forge/base/scene/track.h"

namespace forge {

class Section;

/// Mass and yaw inertia of a class by its box; length and width in m.
struct BodyOptions {
  // mass of a vehicle = max(least_mass, mass + per_size * (length * width)^exponent)
  double mass = 0.0;  ///< kg, term of the formula; may be negative. A class with `mass` alone in
                      ///< the file has this mass at any size
  double per_size = 0.0;    ///< kg/m^(2 exponent)
  double exponent = 1.0;    ///< without unit
  double least_mass = 0.0;  ///< kg, lower bound
  double inertia = 1.0;     ///< factor on a uniform box's mass * (length^2 + width^2) / 12
};

/// Coefficient of restitution by closing speed v (m/s): least + low_speed * exp(-decay * v).
struct RestitutionOptions {
  double least = 0.0;      ///< 0..1, at high speeds
  double low_speed = 0.0;  ///< 0..1, added at v = 0
  double decay = 0.0;      ///< s/m
};

/// Injury probability of occupants if one side is hit, 1 / (1 + exp(-(a + b * delta-v /
/// OccupantOptions::speed_unit))), as [a, b]. The probability of MAIS 3 is capped at the one of
/// MAIS 2.
struct OccupantCurve {
  std::array<double, 2> mais2 = {};  ///< of an injury of MAIS 2 or more
  std::array<double, 2> mais3 = {};  ///< of an injury of MAIS 3 or more
};

/// Injury curves of occupants by the side that is hit.
struct OccupantOptions {
  std::string curve;        ///< name of the publication
  double speed_unit = 1.0;  ///< m/s; unit of delta-v in the publication
  OccupantCurve front;
  OccupantCurve side;
  OccupantCurve rear;
};

/// Injury probability of pedestrians and riders: 1 / (1 + exp(-(a + b * dv + c * dh + d * dv *
/// dh))), as [a, b, c, d]. dv (km/h) is the relative speed minus the shift below minus 42.79, dh
/// (cm) the height of the other vehicle's bonnet edge minus 85.25; see config/severity.yaml. The
/// probability of MAIS 3 is capped at the one of MAIS 2.
struct VulnerableOptions {
  std::string curve;                 ///< name of the publication
  double car_bonnet_edge = 0.0;      ///< cm, height of a car's bonnet edge
  double other_bonnet_edge = 0.0;    ///< cm, the same for other vehicles
  std::array<double, 4> mais2 = {};  ///< of an injury of MAIS 2 or more
  std::array<double, 4> mais3 = {};  ///< of an injury of MAIS 3 or more
  std::array<double, 4> fatal = {};  ///< of a fatal injury
  double bicycle_shift = 0.0;        ///< km/h more than a pedestrian needs for the same probability
  double motorcycle_shift = 0.0;     ///< km/h, the same for a motorcyclist
  double scooter_shift = 0.0;        ///< km/h, the same for the rider of a scooter
};

/// Motion on the road after the impact, until both parties stand.
struct AfterImpactOptions {
  double tyre_friction = 0.0;    ///< friction coefficient of a tyre that slides
  double ground_friction = 0.0;  ///< friction coefficient of people, fallen riders and objects
  double rolling_drag = 0.0;     ///< drag of a wheel that rolls, as a share of its load
  /// m/s; an impact that changes a vehicle's velocity by at least this locks the wheels of the
  /// struck end
  double locking_delta_v = 0.0;
  double braking_delay = 0.0;  ///< s from the contact until the driver brakes
  /// m/s2, deceleration by the driver of a vehicle with wheels after the delay
  double braking = 0.0;
};

/// Bounds of delta-v (km/h) from which S1, S2 and S3 of ISO 26262 apply, in this order.
struct SeverityBounds {
  /// lower of the published bounds; gives CrashEffect::most_class
  std::array<double, 3> lower = {};
  /// upper of the published bounds; gives CrashEffect::least_class
  std::array<double, 3> upper = {};
};

/// config/severity.yaml, which has the sources.
struct SeverityOptions {
  /// In the order of AgentClass.
  std::array<BodyOptions, static_cast<std::size_t>(kLastAgentClass) + 1> bodies;
  /// s from the first touch, at unchanged velocities, to the overlap in whose middle the impulse
  /// acts
  double engagement = 0.0;
  /// largest ratio of tangential to normal impulse between the bodies, >= 0
  double friction = 0.0;
  RestitutionOptions restitution;
  AfterImpactOptions after_impact;
  OccupantOptions occupants;
  VulnerableOptions vulnerable;
  SeverityBounds head_on;  ///< of a party hit on its front, force from 12 o'clock (clockHour())
  SeverityBounds rear;     ///< of a party hit on its rear
  SeverityBounds side;     ///< of a party hit on its left or right side
  SeverityBounds oblique;  ///< of a party hit on its front, force from another direction
};

/// Reads the struct from its section. Throws ConfigError for a missing key or a value out of range.
void readOptions(Section& section, SeverityOptions& options);

}  // namespace forge
