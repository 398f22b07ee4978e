#pragma once

namespace forge {

class ConfigFolder;
class Section;

/// config/ranks.yaml, where each number's unit and source stand.
struct RankOptions {
  double max_silence = 0.0;
  double max_meeting = 0.0;
};

void readOptions(Section& section, RankOptions& options);

/// Reads ranks.yaml of the configuration. Throws ConfigError.
RankOptions loadRankOptions(const ConfigFolder& folder);

}  // namespace forge
