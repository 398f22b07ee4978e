#pragma once

#include <string>
#include <vector>

#include "collision_forge/io/answers/options.h"
#include "collision_forge/io/drawing/options.h"
#include "collision_forge/io/logs/log_source.h"
#include "collision_forge/planner_test/report/options.h"
#include "collision_forge/planner_test/report/report_files.h"

namespace forge {

struct ReportInputs {
  std::vector<std::string> files;  ///< as openReportFile() takes them
  LogSource logs;                  ///< that they are of; without a path: none
};

struct ReportSettings {
  const ReportOptions& report;
  const DrawingOptions& drawing;
  const AnswerOptions& options;
  double seconds_after_stand = 0.0;     ///< of AttackedBagOptions: how long a crash is shown
  std::vector<RowFormat> formats = {};  ///< files of rows that the page shows beside ours
};

/// Writes FOLDER/index.html, a page of all that is in the files, with progress on stderr. With a
/// source of logs it shows map and traffic, and holds attacks against the recording. It shows the
/// motions of planner tests of scenario files that are among the inputs. Returns the rows of its
/// table. Throws std::runtime_error and the errors of those who read, naming file and line.
std::size_t writeReportPage(const ReportInputs& inputs, const std::string& folder,
                            const ReportSettings& settings);

}  // namespace forge
