#include "collision_forge/study/evaluation/options.h"

#include <algorithm>

#include "collision_forge/base/config/section.h"

namespace forge {

static void readOptions(Section& section, ControlOptions& options) {
  options.impact_speeds = section.numbers("impact_speeds", 0.0, 100.0);
  if (!std::is_sorted(options.impact_speeds.begin(), options.impact_speeds.end())) {
    section.refuse("impact_speeds", "is not in ascending order");
  }
  options.overlaps = section.risingShares("overlaps");
}

void readOptions(Section& section, EvaluationOptions& options) {
  section.read("controls", options.controls);
}

}  // namespace forge
