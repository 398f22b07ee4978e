#pragma once

#include <string>
#include <vector>

#include "collision_forge/attack/search/catalogue.h"
#include "collision_forge/io/answers/options.h"
#include "collision_forge/io/drawing/options.h"
#include "collision_forge/io/logs/log_source.h"
#include "collision_forge/planner_test/report/options.h"
#include "collision_forge/planner_test/report/report_files.h"

namespace forge {

/// Input files of a report page.
struct ReportInputs {
  std::vector<std::string> files;  ///< of the kinds in ReportFileKind
  LogSource logs;                  ///< recordings of these files; no path: none
};

/// Settings of a report page. References must outlive writeReportPage().
struct ReportSettings {
  const ReportOptions& report;
  const DrawingOptions& drawing;
  const AnswerOptions& options;
  double seconds_after_stand =
      0.0;  ///< s that a crash is shown after both vehicles stop (AttackedBagOptions)
  std::vector<CatalogueEntry> catalogue = {};  ///< rows of the page of coverage
};

/// Writes FOLDER/index.html, a page of all results in the files, with progress on stderr. With
/// recordings it also shows map and traffic and replays attacks against the recorded ego. Motions
/// of planner tests are shown if their scenario file is among the inputs. Requests that were
/// made from a catalogue add FOLDER/coverage.html, a page of its cells. Returns the number of table
/// rows. Throws std::runtime_error and the errors of the readers, naming file and line.
std::size_t writeReportPage(const ReportInputs& inputs, const std::string& folder,
                            const ReportSettings& settings);

}  // namespace forge
