#include "collision_forge/statistics/options.h"

#include "collision_forge/config/section.h"

namespace forge {

void readOptions(Section& section, StatisticsOptions& options) {
  options.resamples = section.count("resamples", 1);
  options.confidence = section.share("confidence");
  options.seed = static_cast<std::uint64_t>(section.count("seed", 0));
}

}  // namespace forge
