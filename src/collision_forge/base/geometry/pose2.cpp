#include "collision_forge/base/geometry/pose2.h"

#include <cmath>

namespace forge {

double wrapAngle(double angle) {
  if (angle > -M_PI && angle <= M_PI) return angle;
  const double wrapped = std::remainder(angle, 2.0 * M_PI);
  return wrapped <= -M_PI ? M_PI : wrapped;
}

double angleBetween(double from, double to) { return wrapAngle(to - from); }

bool Pose2::isFinite() const { return std::isfinite(x) && std::isfinite(y) && std::isfinite(yaw); }

Pose2 compose(const Pose2& base, const Pose2& local) {
  const Vector2 forward = base.heading();
  return {base.x + forward.x() * local.x - forward.y() * local.y,
          base.y + forward.y() * local.x + forward.x() * local.y, wrapAngle(base.yaw + local.yaw)};
}

Pose2 relativeTo(const Pose2& base, const Pose2& target) {
  const Vector2 forward = base.heading();
  const Vector2 offset = target.position() - base.position();
  return {forward.x() * offset.x() + forward.y() * offset.y(),
          forward.x() * offset.y() - forward.y() * offset.x(), angleBetween(base.yaw, target.yaw)};
}

Pose2 interpolate(const Pose2& a, const Pose2& b, double ratio) {
  return {a.x + ratio * (b.x - a.x), a.y + ratio * (b.y - a.y),
          wrapAngle(a.yaw + ratio * angleBetween(a.yaw, b.yaw))};
}

}  // namespace forge
