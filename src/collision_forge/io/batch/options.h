#pragma once

#include <string>

namespace forge {

class Section;

/// config/ranks.yaml, where each number's unit and source stand.
struct RankOptions {
  double max_silence = 0.0;
  double max_meeting = 0.0;
};

void readOptions(Section& section, RankOptions& options);

/// Reads ranks.yaml of the folder. Throws ConfigError.
RankOptions loadRankOptions(const std::string& directory);

}  // namespace forge
