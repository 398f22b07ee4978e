#include "collision_forge/attack/search/search_task.h"

#include <cmath>

namespace forge {

bool isExact(const PatternMiss& miss, const SearchOptions& options) {
  return miss.distance <= options.exact_distance && miss.heading <= options.exact_heading;
}

}  // namespace forge
