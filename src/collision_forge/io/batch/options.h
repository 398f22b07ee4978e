#pragma once

namespace forge {

class ConfigFolder;
class Section;

/// Runs over the ranks of mpirun (config/ranks.yaml).
struct RankOptions {
  double max_silence = 0.0;  ///< s without a heartbeat of a rank after which the run ends
  double max_meeting = 0.0;  ///< s that ranks wait for each other at the start and the end of MPI
};

void readOptions(Section& section, RankOptions& options);

/// Reads ranks.yaml. Throws ConfigError.
RankOptions loadRankOptions(const ConfigFolder& folder);

}  // namespace forge
