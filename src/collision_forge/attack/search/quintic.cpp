#include "collision_forge/attack/search/quintic.h"

#include <stdexcept>

namespace forge {

Quintic::Quintic(const AxisState& start, const AxisState& end, double duration) {
  if (!(duration > 0.0)) throw std::invalid_argument("a quintic needs a positive duration");
  const double t = duration;
  const double t2 = t * t;
  // Differences at the end from the start's parabola.
  const double dp =
      end.position - start.position - start.velocity * t - 0.5 * start.acceleration * t2;
  const double dv = end.velocity - start.velocity - start.acceleration * t;
  const double da = end.acceleration - start.acceleration;
  coefficients_ = {start.position,
                   start.velocity,
                   0.5 * start.acceleration,
                   (10.0 * dp - 4.0 * dv * t + 0.5 * da * t2) / (t2 * t),
                   (-15.0 * dp + 7.0 * dv * t - da * t2) / (t2 * t2),
                   (6.0 * dp - 3.0 * dv * t + 0.5 * da * t2) / (t2 * t2 * t)};
}

AxisState Quintic::at(double time) const {
  const auto& c = coefficients_;
  const double t = time;
  return {c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * (c[4] + t * c[5])))),
          c[1] + t * (2.0 * c[2] + t * (3.0 * c[3] + t * (4.0 * c[4] + t * 5.0 * c[5]))),
          2.0 * c[2] + t * (6.0 * c[3] + t * (12.0 * c[4] + t * 20.0 * c[5]))};
}

}  // namespace forge
