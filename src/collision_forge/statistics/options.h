#pragma once

#include <cstdint>

namespace forge {

class Section;

/// config/evaluation.yaml, section statistics, where each number's unit and source stand.
struct StatisticsOptions {
  int resamples = 0;
  double confidence = 0.0;
  std::uint64_t seed = 0;
};

void readOptions(Section& section, StatisticsOptions& options);

}  // namespace forge
