#include "collision_forge/attack/severity/options.h"

#include <algorithm>
#include <vector>

#include "collision_forge/base/config/section.h"

namespace forge {
namespace {

constexpr double kMaxCoefficient = 1e6;  // of formulas; beyond it their values are not numbers

/// Reads the mapping under a key with readPart().
template <typename Part>
void readUnder(Section& section, const std::string& key, Part& part);

/// Reads a list of exactly the array's size.
template <std::size_t kSize>
void readList(Section& section, const std::string& key, double min,
              std::array<double, kSize>& values) {
  const std::vector<double> read = section.numbers(key, min, kMaxCoefficient);
  if (read.size() != kSize) section.refuse(key, "needs " + std::to_string(kSize) + " numbers");
  std::copy(read.begin(), read.end(), values.begin());
}

void readPart(Section& section, BodyOptions& body) {
  body.inertia = section.positive("inertia");
  if (!section.has("per_size")) {
    body.mass = section.positive("mass");
    body.least_mass = body.mass;
    return;
  }
  body.mass = section.within("mass", -kMaxCoefficient, kMaxCoefficient);
  body.per_size = section.positive("per_size");
  body.exponent = section.positive("exponent");
  body.least_mass = section.positive("least_mass");
}

void readPart(Section& section, RestitutionOptions& restitution) {
  restitution.least = section.share("least");
  restitution.low_speed = section.within("low_speed", 0.0, 1.0 - restitution.least);
  restitution.decay = section.nonNegative("decay");
}

void readPart(Section& section, AfterImpactOptions& after) {
  after.tyre_friction = section.positive("tyre_friction");
  after.ground_friction = section.positive("ground_friction");
  after.rolling_drag = section.positive("rolling_drag");
  after.locking_delta_v = section.nonNegative("locking_delta_v");
  after.braking_delay = section.nonNegative("braking_delay");
  after.braking = section.nonNegative("braking");
}

void readPart(Section& section, OccupantCurve& curve) {
  readList(section, "mais2", -kMaxCoefficient, curve.mais2);
  readList(section, "mais3", -kMaxCoefficient, curve.mais3);
}

void readPart(Section& section, OccupantOptions& occupants) {
  occupants.curve = section.text("curve");
  occupants.speed_unit = section.positive("speed_unit");
  readUnder(section, "front", occupants.front);
  readUnder(section, "side", occupants.side);
  readUnder(section, "rear", occupants.rear);
}

void readPart(Section& section, VulnerableOptions& vulnerable) {
  vulnerable.curve = section.text("curve");
  Section edge = section.section("bonnet_edge");
  vulnerable.car_bonnet_edge = edge.positive("car");
  vulnerable.other_bonnet_edge = edge.positive("other");
  edge.finish();
  readList(section, "mais2", -kMaxCoefficient, vulnerable.mais2);
  readList(section, "mais3", -kMaxCoefficient, vulnerable.mais3);
  readList(section, "fatal", -kMaxCoefficient, vulnerable.fatal);
  Section shift = section.section("rider_shift");
  vulnerable.bicycle_shift = shift.nonNegative("bicycle");
  vulnerable.motorcycle_shift = shift.nonNegative("motorcycle");
  vulnerable.scooter_shift = shift.nonNegative("scooter");
  shift.finish();
}

void readPart(Section& section, SeverityBounds& bounds) {
  readList(section, "lower", 0.0, bounds.lower);
  readList(section, "upper", 0.0, bounds.upper);
  for (std::size_t i = 0; i < bounds.lower.size(); ++i) {
    if (bounds.upper[i] < bounds.lower[i]) section.refuse("upper", "is below lower");
  }
}

template <typename Part>
void readUnder(Section& section, const std::string& key, Part& part) {
  Section inner = section.section(key);
  readPart(inner, part);
  inner.finish();
}

}  // namespace

void readOptions(Section& section, SeverityOptions& options) {
  Section bodies = section.section("bodies");
  for (std::size_t i = 0; i < options.bodies.size(); ++i) {
    readUnder(bodies, toString(static_cast<AgentClass>(i)), options.bodies[i]);
  }
  bodies.finish();
  options.engagement = section.nonNegative("engagement");
  options.friction = section.nonNegative("friction");
  readUnder(section, "restitution", options.restitution);
  readUnder(section, "after_impact", options.after_impact);
  readUnder(section, "occupants", options.occupants);
  readUnder(section, "vulnerable", options.vulnerable);
  Section classes = section.section("iso_26262");
  readUnder(classes, "head_on", options.head_on);
  readUnder(classes, "rear", options.rear);
  readUnder(classes, "side", options.side);
  readUnder(classes, "oblique", options.oblique);
  classes.finish();
}

}  // namespace forge
