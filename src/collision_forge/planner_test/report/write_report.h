#pragma once

#include <string>
#include <vector>

#include "collision_forge/io/answers/options.h"
#include "collision_forge/io/drawing/options.h"
#include "collision_forge/io/logs/log_source.h"
#include "collision_forge/planner_test/report/options.h"
#include "collision_forge/planner_test/report/report_files.h"
#include "collision_forge/planner_test/trials/options.h"
#include "collision_forge/planner_test/trials/planner_tuning.h"
#include "collision_forge/planner_test/trials/traffic.h"

namespace forge {

struct ReportInputs {
  std::vector<std::string> files;               ///< as openReportFile() takes them
  LogSource logs;                               ///< that they are of; without a path: none
  Background background = Background::kReplay;  ///< that planners were tested against
  int jobs = 1;                                 ///< planner tests driven at a time
  /// Of forge tune: rows that are named as one of these are that planner with its options.
  std::string planner = {};
  std::vector<PlannerVariant> variants = {};
};

struct ReportSettings {
  const ReportOptions& report;
  const DrawingOptions& drawing;
  const AnswerOptions& options;
  const TrialOptions& trials;
  double seconds_after_stand = 0.0;     ///< of AttackedBagOptions: how long a crash is shown
  std::vector<RowFormat> formats = {};  ///< files of rows that the page shows beside ours
};

/// Writes FOLDER/index.html, a page of all that is in the files, with progress on stderr. With a
/// source of logs it shows map and traffic, holds attacks against the recording, and drives planner
/// tests of scenario files that are among the inputs again, for their motion. Returns the rows of
/// its table. Throws std::runtime_error and the errors of those who read, naming file and line.
std::size_t writeReportPage(const ReportInputs& inputs, const std::string& folder,
                            const ReportSettings& settings);

}  // namespace forge
