#include "collision_forge/planner_test/report/options.h"

#include "collision_forge/base/config/section.h"

namespace forge {

void readOptions(Section& section, ReportOptions& options) {
  options.seconds_before_now = section.nonNegative("seconds_before_now");
}

}  // namespace forge
