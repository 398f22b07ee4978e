#include "collision_forge/attack/severity/impact.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <stdexcept>
#include <string>

#include <Eigen/LU>

#include "collision_forge/base/scene/number_words.h"

namespace forge {
namespace {

Vector2 leftOf(const Vector2& vector) { return {-vector.y(), vector.x()}; }

double cross(const Vector2& a, const Vector2& b) { return a.x() * b.y() - a.y() * b.x(); }

void requireFinite(const std::string& name, std::initializer_list<double> values) {
  for (const double value : values) {
    if (!std::isfinite(value)) throw std::invalid_argument(name + " is not finite");
  }
}

void check(const std::string& body, const ImpactBody& of) {
  requireFinite(body + ": mass or yaw inertia", {of.mass, of.yaw_inertia});
  if (of.mass <= 0.0) {
    throw std::invalid_argument(body + ": mass " + numberText(of.mass) + " kg is not positive");
  }
  if (of.yaw_inertia <= 0.0) {
    throw std::invalid_argument(body + ": yaw inertia " + numberText(of.yaw_inertia) +
                                " kg m2 is not positive");
  }
  requireFinite(body + ": position, velocity or yaw rate",
                {of.center.x(), of.center.y(), of.velocity.x(), of.velocity.y(), of.yaw_rate});
}

void check(const ImpactContact& contact) {
  constexpr double kUnitTolerance = 1e-6;
  requireFinite("contact: point", {contact.point.x(), contact.point.y()});
  if (!(std::abs(contact.normal.norm() - 1.0) <= kUnitTolerance)) {
    throw std::invalid_argument("contact: the length of the normal is not 1");
  }
  if (!(contact.restitution >= 0.0 && contact.restitution <= 1.0)) {
    throw std::invalid_argument("contact: restitution " + numberText(contact.restitution) +
                                " is not within 0 to 1");
  }
  if (!std::isfinite(contact.friction) || contact.friction < 0.0) {
    throw std::invalid_argument("contact: friction " + numberText(contact.friction) +
                                " is not a number of 0 or more");
  }
}

/// Change of the contact velocity per impulse on the first body, in the axes (normal, tangent).
Eigen::Matrix2d mobility(const ImpactBody& first, const ImpactBody& second,
                         const ImpactContact& contact) {
  Eigen::Matrix2d sum = (1.0 / first.mass + 1.0 / second.mass) * Eigen::Matrix2d::Identity();
  for (const ImpactBody* body : {&first, &second}) {
    const Vector2 arm = contact.point - body->center;
    const Vector2 lever(-arm.dot(leftOf(contact.normal)), arm.dot(contact.normal));
    sum += lever * lever.transpose() / body->yaw_inertia;
  }
  return sum;
}

/// Returns the impulse on the first body in the axes (normal, tangent); `u`: contact velocity in
/// these axes, with u.x() > 0 (closing).
Vector2 impulseOf(const Eigen::Matrix2d& mobility, const Vector2& u, double restitution,
                  double friction) {
  const Vector2 sticking = mobility.inverse() * -Vector2((1.0 + restitution) * u.x(), u.y());
  const bool presses = sticking.x() < 0.0;
  if (presses && std::abs(sticking.y()) <= friction * -sticking.x()) return sticking;
  // Sliding to the end. If sticking would need a pull, friction opposes the sliding at the start.
  const double sign = presses ? (sticking.y() < 0.0 ? 1.0 : -1.0) : (u.y() < 0.0 ? -1.0 : 1.0);
  const double ratio = sign * friction;
  const double normal = -(1.0 + restitution) * u.x() / (mobility(0, 0) + ratio * mobility(0, 1));
  return {normal, ratio * normal};
}

ImpactChange changeOf(const ImpactBody& body, const Vector2& impulse, const Vector2& point) {
  return {impulse / body.mass, cross(point - body.center, impulse) / body.yaw_inertia};
}

}  // namespace

Vector2 contactVelocity(const ImpactBody& first, const ImpactBody& second, const Vector2& point) {
  const auto at = [&](const ImpactBody& body) -> Vector2 {
    return body.velocity + body.yaw_rate * leftOf(point - body.center);
  };
  return at(first) - at(second);
}

Impact planarImpact(const ImpactBody& first, const ImpactBody& second,
                    const ImpactContact& contact) {
  check("first body", first);
  check("second body", second);
  check(contact);
  ImpactContact plane = contact;  // with the normal from the first to the second body
  if ((second.center - first.center).dot(plane.normal) < 0.0) plane.normal = -plane.normal;
  const Vector2 tangent = leftOf(plane.normal);
  const Vector2 velocity = contactVelocity(first, second, plane.point);
  const Vector2 u(velocity.dot(plane.normal), velocity.dot(tangent));
  Impact impact;
  if (u.x() <= 0.0) return impact;
  const Eigen::Matrix2d inverse_mass = mobility(first, second, plane);
  const auto lostBy = [&](const Vector2& impulse) {
    return -impulse.dot(u + 0.5 * inverse_mass * impulse);
  };
  Vector2 impulse = impulseOf(inverse_mass, u, plane.restitution, plane.friction);
  if (lostBy(impulse) < 0.0) impulse = impulseOf(inverse_mass, u, 0.0, plane.friction);
  impact.energy_lost = std::max(lostBy(impulse), 0.0);
  impact.impulse_ratio = impulse.y() / impulse.x();
  impact.impulse = impulse.x() * plane.normal + impulse.y() * tangent;
  impact.first = changeOf(first, impact.impulse, plane.point);
  impact.second = changeOf(second, -impact.impulse, plane.point);
  return impact;
}

}  // namespace forge
