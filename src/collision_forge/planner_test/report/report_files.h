#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/base/scene/input_limits.h"
#include "collision_forge/planner_test/report/report_row.h"

namespace forge {

/// Kinds of input files of forge report.
enum class ReportFileKind {
  kScenarios,     ///< output of forge generate, or the attempts of forge study dataset
  kPlannerTests,  ///< results.jsonl of forge test, train.jsonl and test.jsonl of forge tune
  kRows,          ///< file of a RowFormat, as results.csv of forge study evaluate
};

/// Extension point: a CSV file with one row of the page's table per line. Modules above this one
/// add formats.
struct RowFormat {
  std::string header;  ///< first line of such a file; identifies the format
  /// Called once for each line after the header, from one thread. Returns its row; empty if the
  /// line is not a row.
  std::function<std::optional<ReportRow>(const std::string& line)> rowOf;
};

/// An input file with its detected kind.
struct ReportFile {
  std::string path;
  ReportFileKind kind;
  RowFormat format = {};  ///< set for kRows
};

/// Detects the kind of a file by its first line. Throws std::runtime_error, naming file and line,
/// if it cannot be read or is of no known kind, InputError as readInputLine().
ReportFile openReportFile(const std::string& path, const std::vector<RowFormat>& formats,
                          const InputLimits& limits);

/// Receives one line: `where` ("FILE: line 2"), the line number from 1 on, the text, and the share
/// (0..1) of the file read so far.
using OnReportLine = std::function<void(const std::string& where, std::size_t line,
                                        const std::string& text, double share)>;
/// Calls `on_line` for each line of a file except a RowFormat's header. Throws as readInputLine().
void readReportLines(const ReportFile& file, const InputLimits& limits,
                     const OnReportLine& on_line);

/// Returns the relative URL of the file at `path` for a page in `folder`.
std::string linkTo(const std::string& path, const std::string& folder);

}  // namespace forge
