#include "collision_forge/attack/severity/severity.h"

#include <algorithm>
#include <cmath>

#include "collision_forge/base/geometry/touch_point.h"

namespace forge {
namespace {

constexpr double kKmh = 1.0 / 3.6;  // m/s

bool isRider(AgentClass agent_class) {
  return agent_class == AgentClass::kMotorcycle || isCycle(agent_class);
}

bool isVulnerable(AgentClass agent_class) { return isOnFoot(agent_class) || isRider(agent_class); }

bool hasOccupants(AgentClass agent_class) {
  return isMotorVehicle(agent_class) && !isVulnerable(agent_class);
}

bool isEnd(Side side) { return side == Side::kFront || side == Side::kRear; }

/// Returns the unit vector out of a side.
Vector2 outwards(const OrientedBox& box, Side side) {
  const Vector2 ahead = box.center.heading();
  switch (side) {
    case Side::kFront:
      return ahead;
    case Side::kRear:
      return -ahead;
    case Side::kLeft:
      return {-ahead.y(), ahead.x()};
    case Side::kRight:
      break;
  }
  return {ahead.y(), -ahead.x()};
}

double logistic(double value) { return 1.0 / (1.0 + std::exp(-value)); }

double classBy(const std::array<double, 3>& bounds, double delta_v) {
  return std::count_if(bounds.begin(), bounds.end(),
                       [=](double bound) { return delta_v >= bound * kKmh; });
}

/// Returns the bounds for a party that is hit on `side`: a front hit from 11 or 1 o'clock or beyond
/// is oblique.
const SeverityBounds& boundsOf(Side side, double force_from, const SeverityOptions& options) {
  if (side == Side::kRear) return options.rear;
  if (side != Side::kFront) return options.side;
  return clockHour(force_from) == 12 ? options.head_on : options.oblique;
}

void addOccupants(Side side, const SeverityOptions& options, CrashEffect& effect) {
  const OccupantOptions& curves = options.occupants;
  const bool is_front = side == Side::kFront;
  const bool is_rear = side == Side::kRear;
  const OccupantCurve& curve = is_front ? curves.front : is_rear ? curves.rear : curves.side;
  const double speed = effect.delta_v / curves.speed_unit;
  effect.mais2 = logistic(curve.mais2[0] + curve.mais2[1] * speed);
  effect.mais3 = std::min(logistic(curve.mais3[0] + curve.mais3[1] * speed), effect.mais2);
  effect.curve = curves.curve + (is_front ? ", front" : is_rear ? ", rear" : ", side");
  const SeverityBounds& bounds = boundsOf(side, effect.force_from, options);
  effect.least_class = static_cast<int>(classBy(bounds.upper, effect.delta_v));
  effect.most_class = static_cast<int>(classBy(bounds.lower, effect.delta_v));
}

/// `closing`: m/s, relative speed of person and vehicle. ISO 26262 by its own definition: S2 from
/// 10 % MAIS 3+ on, S3 from 10 % MAIS 5+ on, which is between fatal and MAIS 3+.
void addVulnerable(AgentClass person, const CrashedVehicle& vehicle, double closing,
                   const VulnerableOptions& curves, CrashEffect& effect) {
  constexpr double kMeanSpeed = 42.79;  // km/h, of the sample; as kMeanEdge
  constexpr double kMeanEdge = 85.25;   // cm
  constexpr double kClassShare = 0.1;
  const double shift = person == AgentClass::kMotorcycle ? curves.motorcycle_shift
                       : person == AgentClass::kBicycle  ? curves.bicycle_shift
                       : person == AgentClass::kScooter  ? curves.scooter_shift
                                                         : 0.0;
  const double edge =
      vehicle.agent_class == AgentClass::kCar ? curves.car_bonnet_edge : curves.other_bonnet_edge;
  const double speed = closing / kKmh - shift - kMeanSpeed;
  const double height = edge - kMeanEdge;
  const auto share = [&](const std::array<double, 4>& of) {
    return logistic(of[0] + of[1] * speed + of[2] * height + of[3] * speed * height);
  };
  effect.mais2 = share(curves.mais2);
  effect.mais3 = std::min(share(curves.mais3), effect.mais2);
  effect.curve = curves.curve + ", " + toString(person);
  const bool is_grave = effect.mais3 >= kClassShare;
  effect.least_class = is_grave && share(curves.fatal) >= kClassShare ? 3 : is_grave ? 2 : 1;
  effect.most_class = is_grave ? 3 : 1;
}

CrashEffect effectOn(const CrashedVehicle& party, const CrashedVehicle& by,
                     const ImpactChange& change, const SeverityOptions& options) {
  CrashEffect effect;
  effect.delta_v = change.velocity.norm();
  effect.yaw_rate_change = change.yaw_rate;
  if (effect.delta_v > 0.0) {
    const double from = std::atan2(-change.velocity.y(), -change.velocity.x());
    effect.force_from = angleBetween(party.state.pose.yaw, from);
  }
  if (isVulnerable(party.agent_class)) {
    const double closing = (party.state.velocity - by.state.velocity).norm();
    addVulnerable(party.agent_class, by, closing, options.vulnerable, effect);
  } else if (hasOccupants(party.agent_class)) {
    addOccupants(touchedSide({party.state.pose, party.size}, {by.state.pose, by.size}), options,
                 effect);
  }
  return effect;
}

OrientedBox boxAfter(const CrashedVehicle& party, double duration) {
  const Vector2 moved = party.state.pose.position() + duration * party.state.velocity;
  return {{moved.x(), moved.y(), party.state.pose.yaw}, party.size};
}

}  // namespace

Vector2 contactNormal(const OrientedBox& first, const OrientedBox& second) {
  constexpr double kParallel = 1e-6;
  const Side first_side = touchedSide(first, second);
  const Side second_side = touchedSide(second, first);
  if (isEnd(first_side) && isEnd(second_side)) {
    const Vector2 mean = outwards(first, first_side) - outwards(second, second_side);
    if (mean.norm() > kParallel) return mean.normalized();
  }
  const auto gaps = axisGaps(first, second);
  return std::max_element(gaps.begin(), gaps.end(),
                          [](const AxisGap& a, const AxisGap& b) { return a.gap < b.gap; })
      ->axis;
}

ImpactBody bodyOf(const CrashedVehicle& party, const SeverityOptions& options) {
  const BodyOptions& body = options.bodies[static_cast<std::size_t>(party.agent_class)];
  const double length = party.size.length;
  const double width = party.size.width;
  const double by_size = body.mass + body.per_size * std::pow(length * width, body.exponent);
  const double mass = std::max(by_size, body.least_mass);
  const double inertia = body.inertia * mass * (length * length + width * width) / 12.0;
  return {mass, inertia, party.state.pose.position(), party.state.velocity, 0.0};
}

Impact impactOf(const CrashedVehicle& first, const CrashedVehicle& second,
                const SeverityOptions& options) {
  const OrientedBox first_box = boxAfter(first, 0.0);
  const OrientedBox second_box = boxAfter(second, 0.0);
  ImpactBody one = bodyOf(first, options);
  ImpactBody two = bodyOf(second, options);
  ImpactContact contact;
  contact.normal = contactNormal(first_box, second_box);
  contact.friction = options.friction;
  const OrientedBox first_engaged = boxAfter(first, options.engagement);
  const OrientedBox second_engaged = boxAfter(second, options.engagement);
  if (const auto middle = intersectionCentroid(first_engaged, second_engaged)) {
    contact.point = *middle;
    one.center = first_engaged.center.position();
    two.center = second_engaged.center.position();
  } else {
    contact.point = touchPoint(first_box, second_box);
  }
  const RestitutionOptions& restitution = options.restitution;
  const double closing = std::abs(contactVelocity(one, two, contact.point).dot(contact.normal));
  contact.restitution =
      restitution.least + restitution.low_speed * std::exp(-restitution.decay * closing);
  return planarImpact(one, two, contact);
}

CrashSeverity severityOf(const CrashedVehicle& ego, const CrashedVehicle& other,
                         const SeverityOptions& options) {
  const Impact impact = impactOf(ego, other, options);
  CrashSeverity severity;
  severity.ego = effectOn(ego, other, impact.first, options);
  severity.other = effectOn(other, ego, impact.second, options);
  severity.energy_lost = impact.energy_lost;
  return severity;
}

}  // namespace forge
