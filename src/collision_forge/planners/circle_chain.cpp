#include "collision_forge/planners/circle_chain.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision_forge/planners/speed_plan.h"

namespace forge {

CircleChain circlesOf(const BoxSize& size, int count) {
  const double radius = 0.5 * std::min(size.length, size.width);
  return {radius, 0.5 * size.length - radius, count};
}

PlacedChain placed(const CircleChain& chain, const Pose2& pose) {
  const Vector2 heading = pose.heading();
  PlacedChain result{pose.position(), {}};
  for (const double along : spread(-chain.reach, chain.reach, chain.count)) {
    result.centers.push_back(result.middle + along * heading);
  }
  return result;
}

double centerDistance(const PlacedChain& a, const PlacedChain& b) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vector2& from : a.centers) {
    for (const Vector2& to : b.centers) least = std::min(least, (from - to).squaredNorm());
  }
  return std::sqrt(least);
}

}  // namespace forge
