#pragma once

namespace forge {

class Section;

/// config/report.yaml, where each number's unit stands.
struct ReportOptions {
  double seconds_before_now = 0.0;
  double map_margin = 60.0;     ///< m of map and traffic kept around the ways of ego and attackers
  double map_tolerance = 0.15;  ///< m that the outlines of the map may be off
};

void readOptions(Section& section, ReportOptions& options);

}  // namespace forge
