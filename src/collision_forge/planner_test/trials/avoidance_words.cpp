#include "collision_forge/planner_test/trials/avoidance_words.h"

#include "collision_forge/base/scene/clock.h"
#include "collision_forge/base/scene/formatted.h"

namespace forge {
namespace {

std::string secondsText(double seconds) { return formatted("%.1f s", seconds); }

}  // namespace

std::string avoidanceText(EvasiveManoeuvre manoeuvre, double start, bool is_evasion) {
  const bool is_at_once = start < kTimeEpsilon;
  if (manoeuvre == EvasiveManoeuvre::kKeeping) {
    if (!is_evasion) return "by driving as recorded";
    return is_at_once ? "by keeping its speed"
                      : "by keeping its speed from " + secondsText(start) + " after t0 on";
  }
  const bool is_both = manoeuvre == EvasiveManoeuvre::kBoth;
  return (is_at_once ? "at once" : "up to " + secondsText(start) + " after t0") + " by " +
         (is_both ? "braking and steering" : toString(manoeuvre));
}

}  // namespace forge
