#pragma once

#include <array>
#include <string>

#include "collision_forge/base/scene/track.h"

namespace forge {

class Section;

/// Mass and yaw inertia of a class by its box.
struct BodyOptions {
  // mass of a vehicle = max(least_mass, mass + per_size * (length * width)^exponent)
  double mass = 0.0;        ///< kg
  double per_size = 0.0;    ///< kg/m^(2 exponent)
  double exponent = 1.0;    ///< without unit
  double least_mass = 0.0;  ///< kg
  double inertia = 1.0;     ///< share of a uniform box's yaw inertia
};

/// Coefficient of restitution by closing speed v (m/s): least + low_speed * exp(-decay * v).
struct RestitutionOptions {
  double least = 0.0;      ///< 0..1, at high speeds
  double low_speed = 0.0;  ///< 0..1, added at v = 0
  double decay = 0.0;      ///< s/m
};

/// Injury probability of occupants if one side is hit, 1 / (1 + exp(-(a + b * delta-v /
/// OccupantOptions::speed_unit))), as [a, b].
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
/// dh))), as [a, b, c, d]; config/severity.yaml defines dv (km/h) and dh (cm).
struct VulnerableOptions {
  std::string curve;                 ///< name of the publication
  double car_bonnet_edge = 0.0;      ///< cm, height of a car's bonnet edge
  double other_bonnet_edge = 0.0;    ///< cm, the same for other vehicles
  std::array<double, 4> mais2 = {};  ///< of an injury of MAIS 2 or more
  std::array<double, 4> mais3 = {};  ///< of an injury of MAIS 3 or more
  std::array<double, 4> fatal = {};  ///< of a fatal injury
  double bicycle_shift = 0.0;        ///< km/h more than a pedestrian's for the same probability
  double motorcycle_shift = 0.0;     ///< km/h, the same for a motorcyclist
  double scooter_shift = 0.0;        ///< km/h, the same for the rider of a scooter
};

/// Motion on the road after the impact, until both parties stand.
struct AfterImpactOptions {
  double tyre_friction = 0.0;    ///< of a tyre that slides, over its load
  double ground_friction = 0.0;  ///< of people, fallen riders and objects, over their weight
  double rolling_drag = 0.0;     ///< of a wheel that rolls, over its load
  double locking_delta_v = 0.0;  ///< m/s; from here on the wheels of the struck end are locked
  double braking_delay = 0.0;    ///< s from the contact until the driver brakes
  double braking = 0.0;          ///< m/s2 of a driver after the delay
};

/// Bounds of delta-v (km/h) from which S1, S2 and S3 of ISO 26262 apply.
struct SeverityBounds {
  std::array<double, 3> lower = {};  ///< lower of the published bounds
  std::array<double, 3> upper = {};  ///< upper of the published bounds
};

/// config/severity.yaml, which has the sources.
struct SeverityOptions {
  std::array<BodyOptions, static_cast<std::size_t>(kLastAgentClass) + 1>
      bodies;  ///< in the order of AgentClass
  double engagement =
      0.0;  ///< s from the first touch to the overlap in whose middle the impulse acts
  double friction = 0.0;  ///< largest ratio of tangential to normal impulse, >= 0
  RestitutionOptions restitution;
  AfterImpactOptions after_impact;
  OccupantOptions occupants;
  VulnerableOptions vulnerable;
  SeverityBounds head_on;
  SeverityBounds rear;
  SeverityBounds side;
  SeverityBounds oblique;
};

/// Reads the struct from its section. Throws ConfigError for a missing key or a value out of range.
void readOptions(Section& section, SeverityOptions& options);

}  // namespace forge
