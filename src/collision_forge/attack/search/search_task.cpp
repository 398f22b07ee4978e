#include "collision_forge/attack/search/search_task.h"

#include <cmath>

namespace forge {

bool isExact(const PatternMiss& miss) {
  return miss.distance <= kExactDistance && miss.heading <= kExactHeading;
}

}  // namespace forge
