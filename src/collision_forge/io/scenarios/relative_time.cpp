#include "collision_forge/io/scenarios/relative_time.h"

#include <cmath>

namespace forge {

double fromNow(double time, double now) {
  constexpr double kMicroseconds = 1e6;  // per second
  return std::round((time - now) * kMicroseconds) / kMicroseconds;
}

}  // namespace forge
