#pragma once

namespace forge {

class Section;

/// config/report.yaml, where each number's unit stands.
struct ReportOptions {
  double seconds_before_now = 0.0;
  double map_margin = 0.0;
  double map_tolerance = 0.0;
};

void readOptions(Section& section, ReportOptions& options);

}  // namespace forge
