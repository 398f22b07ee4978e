#pragma once

#include <array>
#include <string>

#include "collision_forge/base/scene/track.h"

namespace forge {

class Section;

/// Mass and yaw inertia of a class by its box.
struct BodyOptions {
  double mass = 0.0;  ///< kg: mass + per_size * (length * width)^exponent ...
  double per_size = 0.0;
  double exponent = 1.0;
  double least_mass = 0.0;  ///< kg; ... but at least this
  double inertia = 1.0;     ///< share of a uniform box's yaw inertia
};

/// Coefficient of restitution by closing speed v (m/s): least + low_speed * exp(-decay * v).
struct RestitutionOptions {
  double least = 0.0;
  double low_speed = 0.0;
  double decay = 0.0;  ///< s/m
};

/// Curves of one side: [a, b] of a logistic function of delta-v.
struct OccupantCurve {
  std::array<double, 2> mais2 = {};
  std::array<double, 2> mais3 = {};
};

struct OccupantOptions {
  std::string curve;        ///< name of the publication
  double speed_unit = 1.0;  ///< m/s
  OccupantCurve front;
  OccupantCurve side;
  OccupantCurve rear;
};

/// Curves of pedestrians and riders: [a, b, c, d] as config/severity.yaml defines them.
struct VulnerableOptions {
  std::string curve;               ///< name of the publication
  double car_bonnet_edge = 0.0;    ///< cm
  double other_bonnet_edge = 0.0;  ///< cm
  std::array<double, 4> mais2 = {};
  std::array<double, 4> mais3 = {};
  std::array<double, 4> fatal = {};
  double bicycle_shift = 0.0;     ///< km/h
  double motorcycle_shift = 0.0;  ///< km/h
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
  std::array<double, 3> lower = {};
  std::array<double, 3> upper = {};
};

/// config/severity.yaml, which has the sources.
struct SeverityOptions {
  std::array<BodyOptions, 11> bodies;  ///< in the order of AgentClass
  double engagement = 0.0;             ///< s
  double friction = 0.0;
  RestitutionOptions restitution;
  AfterImpactOptions after_impact;
  OccupantOptions occupants;
  VulnerableOptions vulnerable;
  SeverityBounds head_on;
  SeverityBounds rear;
  SeverityBounds side;
  SeverityBounds oblique;
};

void readOptions(Section& section, SeverityOptions& options);

}  // namespace forge
