#include "collision_forge/base/geometry/swept_contact.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace forge {
namespace {

// Smallest tolerance: m, plus m per m that the boxes move.
constexpr double kMinTolerance = 1e-6;

bool isFinite(const BoxMotion& motion) {
  return motion.start.isFinite() && motion.end.isFinite() && std::isfinite(motion.size.length) &&
         std::isfinite(motion.size.width);
}

Vector2 displacement(const BoxMotion& motion) {
  return motion.end.position() - motion.start.position();
}

OrientedBox boxAt(const BoxMotion& motion, double time) {
  return {interpolate(motion.start, motion.end, time), motion.size};
}

// Upper bound of the speed that the rotation gives any point of the box, m per unit time.
double turningSpeed(const BoxMotion& motion) {
  return std::abs(angleBetween(motion.start.yaw, motion.end.yaw)) * circumradius(motion.size);
}

// Returns false if the circles around the boxes stay farther apart than `tolerance`.
bool circlesMeet(const BoxMotion& a, const BoxMotion& b, double tolerance) {
  const Vector2 offset = b.start.position() - a.start.position();
  const Vector2 velocity = displacement(b) - displacement(a);
  const double squared_speed = velocity.squaredNorm();
  const double closest =
      squared_speed > 0.0 ? std::clamp(-offset.dot(velocity) / squared_speed, 0.0, 1.0) : 0.0;
  return (offset + closest * velocity).norm() <=
         circumradius(a.size) + circumradius(b.size) + tolerance;
}

}  // namespace

std::optional<double> firstContact(const BoxMotion& a, const BoxMotion& b, double tolerance) {
  if (!isFinite(a) || !isFinite(b) || !std::isfinite(tolerance)) {
    throw std::invalid_argument("box motion is not finite");
  }
  const Vector2 approach = displacement(a) - displacement(b);
  const double turning = turningSpeed(a) + turningSpeed(b);
  tolerance = std::max(tolerance, kMinTolerance * (1.0 + approach.norm() + turning));
  if (!circlesMeet(a, b, tolerance)) {
    return std::nullopt;
  }
  const double contact_gap = tolerance * M_SQRT1_2;  // see axisGaps

  // A gap along a fixed axis shrinks no faster than the approach of the centres along it plus the
  // effect of rotation, so each open gap gives a time without contact; the longest is skipped.
  // Every step takes at least contact_gap over that speed, so there are at most about a million
  // steps.
  double time = 0.0;
  while (true) {
    double step = 0.0;
    for (const AxisGap& axis_gap : axisGaps(boxAt(a, time), boxAt(b, time))) {
      if (axis_gap.gap <= contact_gap) {
        continue;
      }
      const double closing_speed = axis_gap.axis.dot(approach) + turning;
      if (axis_gap.gap > closing_speed * (1.0 - time)) {
        return std::nullopt;
      }
      step = std::max(step, axis_gap.gap / closing_speed);
    }
    if (step == 0.0) {
      return time;
    }
    time = std::min(time + step, 1.0);
  }
}

}  // namespace forge
