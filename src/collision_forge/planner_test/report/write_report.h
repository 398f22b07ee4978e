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
  std::vector<std::string> files;  ///< paths of files of the kinds in ReportFileKind, in any order
  /// Recordings from which the scenario files were made; an empty `logs.path`: none.
  LogSource logs;
};

/// Settings of a report page. References must outlive writeReportPage().
struct ReportSettings {
  const ReportOptions& report;    ///< extent of the shown scenes
  const DrawingOptions& drawing;  ///< colours
  const AnswerOptions& options;   ///< limits of inputs, crash definition, verification and severity
  /// s that a crash is shown after both vehicles have stopped (AttackedBagOptions).
  double seconds_after_stand = 0.0;
  /// Entries of all catalogues, the rows of the page of coverage.
  std::vector<CatalogueEntry> catalogue = {};
};

/// Writes FOLDER/index.html, a page of all results in the files, with progress on stderr; creates
/// the folder and replaces an older page. Writes the page even if its table is empty. Returns the
/// number of rows of the table: one per line of a scenario file (attack or rejection), one more per
/// alternative in it, and per line of a planner-test file one per element of its "planners", but at
/// least one; PNG files have none. Throws std::runtime_error and the errors of the readers, naming
/// file and line; also if recordings are given and lack the scene of a scenario, for a file without
/// lines, and as AsideFile for an error of writing. An older index.html then stays, unless writing
/// coverage.html failed.
/// - With recordings, the page also shows map and traffic, and attacks are replayed against the
/// recorded ego.
/// - Motions of planner tests are shown if their scenario file is among the inputs; FILE:LINE, the
/// name of a test's case, refers to it by its file name without folder and extension.
/// - If requests were made from a catalogue, writes FOLDER/coverage.html, too: a page of its cells
/// (Coverage).
std::size_t writeReportPage(const ReportInputs& inputs, const std::string& folder,
                            const ReportSettings& settings);

}  // namespace forge
