#pragma once

namespace forge {

class Section;

/// Options of forge report: config/report.yaml.
struct ReportOptions {
  double seconds_before_now = 0.0;  ///< s of the recording shown before t0
  double map_margin = 60.0;     ///< m of map and traffic kept around the paths of ego and attackers
  double map_tolerance = 0.15;  ///< m, largest deviation of simplified map outlines
};

/// Reads report.yaml, whose keys are the members without a value here. Throws ConfigError for a
/// missing or malformed key.
void readOptions(Section& section, ReportOptions& options);

}  // namespace forge
