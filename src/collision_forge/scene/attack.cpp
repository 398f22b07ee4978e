#include "collision_forge/scene/attack.h"

#include <cmath>

namespace forge {

PatternMiss missBetween(const Pose2& asked, const Pose2& found) {
  return {(found.position() - asked.position()).norm(),
          std::abs(angleBetween(asked.yaw, found.yaw))};
}

double cornerMiss(const PatternMiss& miss, const BoxSize& attacker) {
  return miss.distance + circumradius(attacker) * miss.heading;
}

}  // namespace forge
